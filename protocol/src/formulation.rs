//! The formulations of ray-sphere and ray-triangle intersection that the tracer's program is
//! linked with, one of each: their names, where they come from, and the kernels that compute by
//! them.
//!
//! None is a flag inside of another: each is kernels of its own, and a program has those of one
//! formulation alone. `spu-build` links by this table, the command line and the benchmark of
//! accuracy choose from it.

/// One formulation of each: those of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Formulations {
    /// Of spheres, for primary rays by depth shading.
    pub eye: &'static SphereFormulation,
    /// Of spheres, for primary rays by Whitted's model.
    pub seen: &'static SphereFormulation,
    /// Of spheres, for the rays of mirrors, glass and shadows. These start where others have hit,
    /// which is no more certain than their length.
    pub bounced: &'static SphereFormulation,
    /// Of triangles.
    pub triangle: &'static TriangleFormulation,
}

/// What a sphere's record holds for primary rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EyeRecord {
    /// The centre as the eye sees it, and the radius squared.
    Centre,
    /// The centre's unit direction and distance, and the square of radius over distance: worked
    /// out in double precision.
    Axis,
}

/// A way to intersect a ray with a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SphereFormulation {
    /// Its name.
    pub name: &'static str,
    /// What is computed.
    pub doc: &'static str,
    /// The kernel for primary rays, which share their origin: depth shading's.
    pub eye: Option<&'static str>,
    /// What that kernel takes of a sphere.
    pub record: EyeRecord,
    /// The kernel for rays from anywhere: Whitted's model's.
    pub general: Option<&'static str>,
}

/// A way to intersect a ray with a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TriangleFormulation {
    /// Its name.
    pub name: &'static str,
    /// What is computed.
    pub doc: &'static str,
    /// The kernel.
    pub kernel: &'static str,
}

const PERPENDICULAR: SphereFormulation = SphereFormulation {
    name: "perpendicular",
    doc: "discriminant by the perpendicular from the centre to the ray (Hearn and Baker), one Newton step",
    eye: Some("isect_pairs_r16"),
    record: EyeRecord::Centre,
    general: Some("isect_sphere_pairs_r16"),
};

/// All formulations of spheres.
pub const SPHERES: &[SphereFormulation] = &[
    SphereFormulation {
        name: "paper",
        doc: "the paper's b^2 - 4ac, one Newton step",
        eye: Some("isect_pairs_paper_r16"),
        general: Some("isect_sphere_pairs_paper_r16"),
        ..PERPENDICULAR
    },
    PERPENDICULAR,
    SphereFormulation {
        name: "estimate",
        doc: "perpendicular, the root from the bare estimate",
        eye: Some("isect_pairs_estimate_r16"),
        general: Some("isect_sphere_pairs_estimate_r16"),
        ..PERPENDICULAR
    },
    SphereFormulation {
        name: "interpolated",
        doc: "perpendicular, the root from estimate and fi",
        eye: Some("isect_pairs_interpolated_r16"),
        general: Some("isect_sphere_pairs_interpolated_r16"),
        ..PERPENDICULAR
    },
    SphereFormulation {
        name: "newton2",
        doc: "perpendicular, two Newton steps",
        eye: Some("isect_pairs_newton2_r16"),
        general: Some("isect_sphere_pairs_newton2_r16"),
        ..PERPENDICULAR
    },
    SphereFormulation {
        name: "stable",
        doc: "perpendicular, the near root as c/q, which does not cancel (Numerical Recipes)",
        eye: Some("isect_pairs_stable_r16"),
        general: Some("isect_sphere_pairs_stable_r16"),
        ..PERPENDICULAR
    },
    SphereFormulation {
        name: "factored",
        doc: "discriminant (r - l)(r + l) (pbrt)",
        eye: Some("isect_pairs_factored_r16"),
        general: Some("isect_sphere_pairs_factored_r16"),
        ..PERPENDICULAR
    },
    SphereFormulation {
        name: "constants",
        doc: "discriminant by the chord from the sphere's axis, with constants in double precision from the PPU",
        eye: Some("isect_pairs_constants_r16"),
        record: EyeRecord::Axis,
        general: None,
    },
    SphereFormulation {
        name: "refined",
        doc: "perpendicular, with what truncation took from b put back",
        eye: Some("isect_pairs_refined_r16"),
        general: Some("isect_sphere_pairs_refined_r16"),
        ..PERPENDICULAR
    },
    SphereFormulation {
        name: "unnormalised",
        doc: "perpendicular, for directions of any length",
        eye: Some("isect_pairs_unnormalised_r16"),
        general: Some("isect_sphere_pairs_unnormalised_r16"),
        ..PERPENDICULAR
    },
    SphereFormulation {
        name: "double",
        doc: "perpendicular and c/q in double precision",
        eye: Some("isect_pairs_double_r16"),
        general: Some("isect_sphere_pairs_double_r16"),
        ..PERPENDICULAR
    },
];

/// All formulations of triangles.
pub const TRIANGLES: &[TriangleFormulation] = &[
    TriangleFormulation {
        name: "watertight",
        doc: "edge tests in the plane across the ray, of the same bits for both sides of an edge (Woop, Benthin, Wald)",
        kernel: "isect_triangle_pairs_r16",
    },
    TriangleFormulation {
        name: "moeller-trumbore",
        doc: "barycentric coordinates by cross products (Moeller, Trumbore)",
        kernel: "isect_triangle_mt_pairs_r16",
    },
];

/// The formulation of spheres of this name.
#[must_use]
pub fn sphere(name: &str) -> Option<&'static SphereFormulation> {
    SPHERES.iter().find(|sphere| sphere.name == name)
}

/// The formulation of triangles of this name.
#[must_use]
pub fn triangle(name: &str) -> Option<&'static TriangleFormulation> {
    TRIANGLES.iter().find(|triangle| triangle.name == name)
}

impl Formulations {
    /// Those that a program has unless others are asked for.
    #[must_use]
    pub fn standard() -> Self {
        Self::named(["constants", "refined", "perpendicular", "watertight"])
            .expect("they are in the tables")
    }

    /// Those of these names, if there are such and each sphere formulation has the kernel that is
    /// asked of it.
    #[must_use]
    pub fn named([eye, seen, bounced, triangle]: [&str; 4]) -> Option<Self> {
        let general = |name| sphere(name).filter(|sphere| sphere.general.is_some());
        Some(Self {
            eye: sphere(eye).filter(|sphere| sphere.eye.is_some())?,
            seen: general(seen)?,
            bounced: general(bounced)?,
            triangle: self::triangle(triangle)?,
        })
    }

    /// One formulation of spheres for all rays that it has a kernel for; the standard one for the
    /// others.
    #[must_use]
    pub fn of(sphere: &'static SphereFormulation, triangle: &'static TriangleFormulation) -> Self {
        let standard = Self::standard();
        Self {
            eye: sphere.eye.map_or(standard.eye, |_| sphere),
            seen: sphere.general.map_or(standard.seen, |_| sphere),
            bounced: sphere.general.map_or(standard.bounced, |_| sphere),
            triangle,
        }
    }

    /// The fastest whose pictures are right to a step of a colour.
    #[must_use]
    pub fn fast() -> Self {
        Self::by("interpolated")
    }

    /// Those of the least error, in double precision.
    #[must_use]
    pub fn exact() -> Self {
        Self::by("double")
    }

    /// The paper's own.
    #[must_use]
    pub fn paper() -> Self {
        Self::by("paper")
    }

    /// Those that `cellray` carries SPU programs of, the standard ones first. The laboratory
    /// builds programs of all others.
    #[must_use]
    pub fn shipped() -> [Self; 4] {
        [Self::standard(), Self::fast(), Self::exact(), Self::paper()]
    }

    /// One formulation of spheres, and the standard one of triangles.
    fn by(name: &str) -> Self {
        let sphere = sphere(name).expect("it is in the table");
        Self::of(sphere, Self::standard().triangle)
    }

    /// The formulation of spheres that tells these from the standard ones: what
    /// [`Formulations::of`] was given, if it has a kernel of any kind.
    #[must_use]
    pub fn named_sphere(&self) -> &'static SphereFormulation {
        let standard = Self::standard();
        if self.eye == standard.eye {
            self.bounced
        } else {
            self.eye
        }
    }

    /// Their names, in the order of the fields.
    #[must_use]
    pub fn names(&self) -> [&'static str; 4] {
        [
            self.eye.name,
            self.seen.name,
            self.bounced.name,
            self.triangle.name,
        ]
    }

    /// A name for all of them: of a file, say.
    #[must_use]
    pub fn name(&self) -> String {
        self.names().join("-")
    }

    /// The kernels of the program's roles: the symbol that the driver calls, and what it stands
    /// for.
    #[must_use]
    pub fn roles(&self) -> [(&'static str, &'static str); 4] {
        [
            ("isect_eye_spheres", self.eye.eye.unwrap_or_default()),
            ("isect_seen_spheres", self.seen.general.unwrap_or_default()),
            (
                "isect_bounced_spheres",
                self.bounced.general.unwrap_or_default(),
            ),
            ("isect_triangles", self.triangle.kernel),
        ]
    }
}
