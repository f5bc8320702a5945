//! The formulations of ray-sphere and ray-triangle intersection: their names, their sources, and
//! the kernels that implement them.
//!
//! Each formulation has its own kernels, and a program is linked with only one formulation for
//! each purpose. `spu-build` links programs by this table. The command line and the accuracy
//! benchmark choose from it.

/// The formulations of a program, one for each purpose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Formulations {
    /// For spheres and the primary rays of depth shading.
    pub eye: &'static SphereFormulation,
    /// For spheres and the primary rays of Whitted's model.
    pub seen: &'static SphereFormulation,
    /// For spheres and the secondary and shadow rays of Whitted's model. The origins of these rays
    /// are hits of other rays, with the error of those rays' lengths.
    pub bounced: &'static SphereFormulation,
    /// For triangles and all rays.
    pub triangle: &'static TriangleFormulation,
}

/// The form of a sphere's record for the primary rays of depth shading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EyeRecord {
    /// The centre relative to the eye, and the square of the radius.
    Centre,
    /// The centre's unit direction and distance, and the square of radius over distance, all
    /// computed in double precision.
    Axis,
}

/// A way to intersect a ray with a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SphereFormulation {
    /// The name of the formulation.
    pub name: &'static str,
    /// A description of the computation, with its source.
    pub doc: &'static str,
    /// The kernel for the primary rays of depth shading, which all start at the eye, if there is
    /// one.
    pub eye: Option<&'static str>,
    /// The form of the records for that kernel.
    pub record: EyeRecord,
    /// The kernel for rays from anywhere, which Whitted's model needs, if there is one.
    pub general: Option<&'static str>,
}

/// A way to intersect a ray with a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TriangleFormulation {
    /// The name of the formulation.
    pub name: &'static str,
    /// A description of the computation, with its source.
    pub doc: &'static str,
    /// The name of the kernel.
    pub kernel: &'static str,
}

const PERPENDICULAR: SphereFormulation = SphereFormulation {
    name: "perpendicular",
    doc: "discriminant by the perpendicular from the centre to the ray (Hearn and Baker), one Newton step",
    eye: Some("isect_pairs_r16"),
    record: EyeRecord::Centre,
    general: Some("isect_sphere_pairs_r16"),
};

/// All formulations for spheres.
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

/// All formulations for triangles.
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

/// The formulation for spheres with this name.
#[must_use]
pub fn sphere(name: &str) -> Option<&'static SphereFormulation> {
    SPHERES.iter().find(|sphere| sphere.name == name)
}

/// The formulation for triangles with this name.
#[must_use]
pub fn triangle(name: &str) -> Option<&'static TriangleFormulation> {
    TRIANGLES.iter().find(|triangle| triangle.name == name)
}

impl Formulations {
    /// The default formulations.
    #[must_use]
    pub fn standard() -> Self {
        Self::named(["constants", "refined", "perpendicular", "watertight"])
            .expect("they are in the tables")
    }

    /// The formulations with these names, in the order of the fields. `None` if a name is unknown,
    /// or if a sphere formulation lacks the kernel that its purpose needs.
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

    /// A sphere formulation for all rays that it has a kernel for, with the standard ones for
    /// other rays.
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

    /// The fastest formulations with pictures that are right to a step of a colour.
    #[must_use]
    pub fn fast() -> Self {
        Self::by("interpolated")
    }

    /// The formulations with the smallest error, in double precision.
    #[must_use]
    pub fn exact() -> Self {
        Self::by("double")
    }

    /// The paper's formulations.
    #[must_use]
    pub fn paper() -> Self {
        Self::by("paper")
    }

    /// The formulations of `cellray`'s built-in SPU programs, the standard ones first. The
    /// laboratory builds programs with all others.
    #[must_use]
    pub fn shipped() -> [Self; 4] {
        [Self::standard(), Self::fast(), Self::exact(), Self::paper()]
    }

    /// A formulation for spheres, with the standard one for triangles.
    fn by(name: &str) -> Self {
        let sphere = sphere(name).expect("it is in the table");
        Self::of(sphere, Self::standard().triangle)
    }

    /// The sphere formulation that distinguishes these from the standard ones: the argument of
    /// [`Formulations::of`], if it has any kernel.
    #[must_use]
    pub fn named_sphere(&self) -> &'static SphereFormulation {
        let standard = Self::standard();
        if self.eye == standard.eye { self.bounced } else { self.eye }
    }

    /// The formulations' names, in the order of the fields.
    #[must_use]
    pub fn names(&self) -> [&'static str; 4] {
        [self.eye.name, self.seen.name, self.bounced.name, self.triangle.name]
    }

    /// A name for the whole combination, for example for a file.
    #[must_use]
    pub fn name(&self) -> String {
        self.names().join("-")
    }

    /// The kernels for the program's roles: the symbol that the driver calls, and the kernel that
    /// it stands for.
    #[must_use]
    pub fn roles(&self) -> [(&'static str, &'static str); 4] {
        [
            ("isect_eye_spheres", self.eye.eye.unwrap_or_default()),
            ("isect_seen_spheres", self.seen.general.unwrap_or_default()),
            ("isect_bounced_spheres", self.bounced.general.unwrap_or_default()),
            ("isect_triangles", self.triangle.kernel),
        ]
    }
}
