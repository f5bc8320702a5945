//! The benchmark as a whole: what is measured of what, and the results.

use kernels::Bench;
use kernels::cases::spheres::cycles_a_ray;
use protocol::formulation::{SPHERES, SphereFormulation, TRIANGLES, TriangleFormulation};
use serde::{Deserialize, Serialize};

use crate::families::Form;
use crate::pictures::{self, PictureError, PictureRow, Sizes};
use crate::roots::{self, RootRow, host_time};
use crate::spheres::{self, SphereRow};
use crate::subject::{self, Subject};
use crate::triangles::{self, TriangleRow};

/// How much is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Extent {
    /// In some seconds, without pictures and roots: what is the same on every host, and checked to
    /// be.
    Quick,
    /// In some minutes.
    Standard,
    /// As much as is worth waiting for.
    Full,
}

/// What is to be measured.
#[derive(Clone, Debug)]
pub struct Order {
    /// How much.
    pub extent: Extent,
    /// Seed of the rays.
    pub seed: u64,
    /// Names of formulations; all if there are none.
    pub only: Vec<String>,
    /// Whether whole pictures are traced.
    pub pictures: bool,
    /// Whether the host's time is measured.
    pub host_time: bool,
}

/// Why there are no results.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// A name that no formulation has.
    #[error("there is no formulation {name}; there are {known}")]
    Formulation {
        /// The name.
        name: String,
        /// Those that there are.
        known: String,
    },
    /// A kernel that the catalogue does not have.
    #[error("{formulation}: there is no kernel {kernel}")]
    Kernel {
        /// The formulation.
        formulation: &'static str,
        /// The kernel that it names.
        kernel: &'static str,
    },
    /// A picture.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

/// What a kernel costs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KernelRow {
    /// The formulation.
    pub formulation: String,
    /// What of: `eye`, `general` or `triangle`.
    pub form: String,
    /// What it computes.
    pub doc: String,
    /// The kernel.
    pub kernel: String,
    /// Simulated cycles in which a ray is tested with an object, in a long list.
    pub cycles_a_ray: f64,
    /// Time of the host's interpreter for the same, in nanoseconds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub host_ns_a_ray: Option<f64>,
}

/// What was measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// How much was to be measured.
    pub extent: Extent,
    /// Seed of the rays.
    pub seed: u64,
    /// What kernels cost.
    pub kernels: Vec<KernelRow>,
    /// Kernels of spheres on the scene families.
    pub spheres: Vec<SphereRow>,
    /// Kernels of triangles on theirs.
    pub triangles: Vec<TriangleRow>,
    /// Reciprocals and roots.
    pub roots: Vec<RootRow>,
    /// Whole pictures.
    pub pictures: Vec<PictureRow>,
}

impl Results {
    /// What kernels of a form cost.
    pub fn kernels_of(&self, form: &str) -> impl Iterator<Item = &KernelRow> {
        self.kernels
            .iter()
            .filter(move |kernel| kernel.form == form)
    }

    /// A formulation's rows of a form, by family.
    pub fn spheres_of(&self, form: Form, formulation: &str) -> Vec<&SphereRow> {
        let of = |row: &&SphereRow| row.form == form && row.formulation == formulation;
        self.spheres.iter().filter(of).collect()
    }
}

impl Extent {
    /// Spheres, or shots of triangles, of each family: 256 rays each.
    pub const fn shots(self) -> usize {
        match self {
            Self::Quick => 4,
            Self::Standard => 64,
            Self::Full => 1024,
        }
    }

    /// How large pictures are.
    pub const fn sizes(self) -> Sizes {
        Sizes {
            depth: (1280, 720),
            whitted: match self {
                Self::Quick | Self::Standard => (480, 270),
                Self::Full => (1280, 720),
            },
        }
    }
}

impl Order {
    /// As little as tests need: a formulation of spheres and one of triangles.
    #[cfg(test)]
    pub fn short(seed: u64) -> Self {
        Self {
            extent: Extent::Quick,
            seed,
            only: vec!["perpendicular".to_owned(), "watertight".to_owned()],
            pictures: false,
            host_time: false,
        }
    }

    fn asks_for(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|asked| asked == name)
    }

    /// Refuses names that nothing has.
    fn check(&self) -> Result<(), RunError> {
        let spheres = SPHERES.iter().map(|formulation| formulation.name);
        let triangles = TRIANGLES.iter().map(|formulation| formulation.name);
        let known: Vec<&str> = spheres.chain(triangles).collect();
        let mut only = self.only.iter();
        match only.find(|name| !known.contains(&name.as_str())) {
            Some(name) => Err(RunError::Formulation {
                name: name.clone(),
                known: known.join(", "),
            }),
            None => Ok(()),
        }
    }
}

/// Measures; `progress` is told what comes next.
///
/// # Errors
///
/// Names of formulations that there are not, pictures that do not come.
pub fn run(order: &Order, mut progress: impl FnMut(&str)) -> Result<Results, RunError> {
    order.check()?;
    let subjects: Vec<Subject> = subject::all()
        .filter(|subject| order.asks_for(subject.formulation.name))
        .collect();
    let flat: Vec<&TriangleFormulation> = TRIANGLES
        .iter()
        .filter(|formulation| order.asks_for(formulation.name))
        .collect();
    progress("cycles of the kernels");
    let kernels = kernels(order, &subjects, &flat)?;
    let shots = order.extent.shots();
    progress("spheres");
    let spheres = spheres::measure(&subjects, order.seed, shots);
    progress("triangles");
    let triangles = triangles::measure(&flat, order.seed, shots);
    let roots = if order.extent == Extent::Quick || !order.only.is_empty() {
        Vec::new()
    } else {
        progress("reciprocals and roots");
        roots::measure(order.host_time)
    };
    let pictures = if order.pictures {
        let asked = |name: &str| order.asks_for(name);
        pictures::measure(asked, &order.extent.sizes(), progress)?
    } else {
        Vec::new()
    };
    Ok(Results {
        extent: order.extent,
        seed: order.seed,
        kernels,
        spheres,
        triangles,
        roots,
        pictures,
    })
}

fn kernels(
    order: &Order,
    subjects: &[Subject],
    flat: &[&TriangleFormulation],
) -> Result<Vec<KernelRow>, RunError> {
    let of_spheres = subjects.iter().map(|subject| {
        let SphereFormulation { name, doc, .. } = *subject.formulation;
        (name, doc, subject.form.name(), subject.kernel)
    });
    let of_triangles = flat
        .iter()
        .map(|flat| (flat.name, flat.doc, "triangle", flat.kernel));
    let mut bench = Bench::new();
    let row = |(formulation, doc, form, kernel): (&'static str, &str, &str, &'static str)| {
        let missing = RunError::Kernel {
            formulation,
            kernel,
        };
        Ok(KernelRow {
            formulation: formulation.to_owned(),
            form: form.to_owned(),
            doc: doc.to_owned(),
            kernel: kernel.to_owned(),
            cycles_a_ray: cycles_a_ray(&mut bench, kernel).ok_or(missing)?,
            host_ns_a_ray: if order.host_time {
                host_time(&mut bench, kernel)
            } else {
                None
            },
        })
    };
    of_spheres.chain(of_triangles).map(row).collect()
}
