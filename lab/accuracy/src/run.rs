//! The whole benchmark: its subjects and its results.

use kernels::Bench;
use kernels::cases::spheres::cycles_a_ray;
use protocol::formulation::{SPHERES, SphereFormulation, TRIANGLES, TriangleFormulation};
use serde::{Deserialize, Serialize};

use crate::families::Form;
use crate::pictures::{self, AntialiasedRow, PictureError, PictureRow};
use crate::roots::{self, RootRow, host_time};
use crate::search::{self, KeptRow};
use crate::spheres::{self, SphereRow};
use crate::subject::{self, Subject};
use crate::totals::Total;
use crate::triangles::{self, TriangleRow};

/// The size of pictures with several samples a pixel.
const ANTIALIASED_SIZE: (u32, u32) = (640, 360);

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
    /// Whether to measure kernels.
    pub kernels: bool,
    /// Whether to trace whole pictures.
    pub pictures: bool,
    /// The names of the scenes to trace. If it is empty, all are traced.
    pub scenes: Vec<String>,
    /// The names of the programs to trace with. If it is empty, all are used.
    pub programs: Vec<String>,
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
    /// Pictures with several samples a pixel.
    pub antialiased: Vec<AntialiasedRow>,
    /// The kept scenes of the search, the worst first.
    pub kept: Vec<KeptRow>,
}

impl Results {
    /// The costs of a form's kernels.
    pub fn kernels_of(&self, form: &str) -> impl Iterator<Item = &KernelRow> {
        self.kernels.iter().filter(move |kernel| kernel.form == form)
    }

    /// The pictures by a program.
    pub fn pictures_by(&self, program: &str) -> impl Iterator<Item = &PictureRow> {
        self.pictures.iter().filter(move |row| row.program == program)
    }

    /// The programs that have traced pictures, each with the sums of all scenes.
    pub fn totals(&self) -> Vec<(&'static str, Total)> {
        let totals =
            pictures::programs().map(|(name, _)| (name, Total::of(self.pictures_by(name))));
        totals.into_iter().filter(|(_, total)| total.cycles > 0.0).collect()
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

    /// The size of pictures.
    pub const fn size(self) -> (u32, u32) {
        match self {
            Self::Quick | Self::Standard => (256, 192),
            Self::Full => (512, 384),
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
            kernels: true,
            pictures: false,
            scenes: Vec::new(),
            programs: Vec::new(),
            host_time: false,
        }
    }

    fn asks_for(&self, name: &str) -> bool {
        self.kernels && (self.only.is_empty() || self.only.iter().any(|asked| asked == name))
    }

    /// Rejects unknown names, before minutes of measuring.
    fn check(&self) -> Result<(), RunError> {
        let spheres = SPHERES.iter().map(|formulation| formulation.name);
        let triangles = TRIANGLES.iter().map(|formulation| formulation.name);
        let known: Vec<&str> = spheres.chain(triangles).collect();
        let mut only = self.only.iter();
        match only.find(|name| !known.contains(&name.as_str())) {
            Some(name) => {
                Err(RunError::Formulation { name: name.clone(), known: known.join(", ") })
            }
            None => Ok(pictures::check(&self.scenes, &self.programs)?),
        }
    }
}

/// Runs the benchmark. `progress` is called with a description of each step.
///
/// # Errors
///
/// Fails for unknown formulations and if a picture can't be traced.
pub fn run(order: &Order, mut progress: impl FnMut(&str) + Send) -> Result<Results, RunError> {
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
    let roots = if order.extent == Extent::Quick || !(order.kernels && order.only.is_empty()) {
        Vec::new()
    } else {
        progress("reciprocals and roots");
        roots::measure(order.host_time)
    };
    let (mut pictures, mut antialiased, mut kept) = (Vec::new(), Vec::new(), Vec::new());
    if order.pictures && order.only.is_empty() {
        pictures = match (&order.scenes[..], &order.programs[..]) {
            ([scene], [program]) => vec![pictures::measure(scene, program, order.extent.size())?],
            (scenes, programs) => {
                pictures::measure_all(scenes, programs, order.extent, &mut progress)?
            }
        };
        if order.scenes.is_empty() {
            progress("pictures with sixteen samples a pixel");
            antialiased = pictures::antialiased(ANTIALIASED_SIZE)?;
            progress("kept scenes of the search");
            kept = search::kept()?;
        }
    }
    Ok(Results {
        extent: order.extent,
        seed: order.seed,
        kernels,
        spheres,
        triangles,
        roots,
        pictures,
        antialiased,
        kept,
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
