//! The whole benchmark: its subjects and its results.

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
    /// Some seconds, without pictures and roots. The results are the same on every host, which is
    /// checked.
    Quick,
    /// Some minutes.
    Standard,
    /// As much as is worth waiting for.
    Full,
}

/// What to measure.
#[derive(Clone, Debug)]
pub struct Order {
    /// The amount.
    pub extent: Extent,
    /// The seed of the rays.
    pub seed: u64,
    /// The names of the formulations to measure. If it is empty, all are measured.
    pub only: Vec<String>,
    /// Whether to trace whole pictures.
    pub pictures: bool,
    /// Whether to measure the host's time.
    pub host_time: bool,
}

/// Why there are no results.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// A name that is not a formulation's.
    #[error("there is no formulation {name}; the formulations are {known}")]
    Formulation {
        /// The name.
        name: String,
        /// The existing names.
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
    /// An error with a picture.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

/// The cost of a kernel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KernelRow {
    /// The formulation.
    pub formulation: String,
    /// Its form: `eye`, `general` or `triangle`.
    pub form: String,
    /// A description of what it computes.
    pub doc: String,
    /// The kernel.
    pub kernel: String,
    /// Simulated cycles for each test of a ray with an object, in a long list.
    pub cycles_a_ray: f64,
    /// The host interpreter's time for the same, in nanoseconds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub host_ns_a_ray: Option<f64>,
}

/// The results.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// The amount that was measured.
    pub extent: Extent,
    /// Seed of the rays.
    pub seed: u64,
    /// The costs of kernels.
    pub kernels: Vec<KernelRow>,
    /// The errors of the kernels of spheres on the scene families.
    pub spheres: Vec<SphereRow>,
    /// The errors of the kernels of triangles on their families.
    pub triangles: Vec<TriangleRow>,
    /// Reciprocals and roots.
    pub roots: Vec<RootRow>,
    /// Whole pictures.
    pub pictures: Vec<PictureRow>,
}

impl Results {
    /// The costs of a form's kernels.
    pub fn kernels_of(&self, form: &str) -> impl Iterator<Item = &KernelRow> {
        self.kernels.iter().filter(move |kernel| kernel.form == form)
    }

    /// A formulation's rows of a form, one for each family.
    pub fn spheres_of(&self, form: Form, formulation: &str) -> Vec<&SphereRow> {
        let of = |row: &&SphereRow| row.form == form && row.formulation == formulation;
        self.spheres.iter().filter(of).collect()
    }
}

impl Extent {
    /// The number of spheres, or of shots at triangles, in each family. Each has 256 rays.
    pub const fn shots(self) -> usize {
        match self {
            Self::Quick => 4,
            Self::Standard => 64,
            Self::Full => 1024,
        }
    }

    /// The sizes of pictures.
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
    /// The smallest order that tests need: one formulation of spheres and one of triangles.
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

    /// Rejects unknown names.
    fn check(&self) -> Result<(), RunError> {
        let spheres = SPHERES.iter().map(|formulation| formulation.name);
        let triangles = TRIANGLES.iter().map(|formulation| formulation.name);
        let known: Vec<&str> = spheres.chain(triangles).collect();
        let mut only = self.only.iter();
        match only.find(|name| !known.contains(&name.as_str())) {
            Some(name) => {
                Err(RunError::Formulation { name: name.clone(), known: known.join(", ") })
            }
            None => Ok(()),
        }
    }
}

/// Runs the benchmark. `progress` is called with a description of each step.
///
/// # Errors
///
/// Fails for unknown formulations and if a picture can't be traced.
pub fn run(order: &Order, mut progress: impl FnMut(&str)) -> Result<Results, RunError> {
    order.check()?;
    let subjects: Vec<Subject> =
        subject::all().filter(|subject| order.asks_for(subject.formulation.name)).collect();
    let flat: Vec<&TriangleFormulation> =
        TRIANGLES.iter().filter(|formulation| order.asks_for(formulation.name)).collect();
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
    let of_triangles = flat.iter().map(|flat| (flat.name, flat.doc, "triangle", flat.kernel));
    let mut bench = Bench::new();
    let row = |(formulation, doc, form, kernel): (&'static str, &str, &str, &'static str)| {
        let missing = RunError::Kernel { formulation, kernel };
        Ok(KernelRow {
            formulation: formulation.to_owned(),
            form: form.to_owned(),
            doc: doc.to_owned(),
            kernel: kernel.to_owned(),
            cycles_a_ray: cycles_a_ray(&mut bench, kernel).ok_or(missing)?,
            host_ns_a_ray: if order.host_time { host_time(&mut bench, kernel) } else { None },
        })
    };
    of_spheres.chain(of_triangles).map(row).collect()
}
