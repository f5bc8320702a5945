//! The kernels that can be called: their images and sources.
//!
//! The [`Workshop`] makes them from the repository's sources. A machine without these and without
//! an SPU assembler, such as a console, reads them from a folder that `kernels pack` filled.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, PoisonError};

use protocol::formulation::{Formulations, SPHERES, TRIANGLES};

use crate::source::Source;
use crate::workshop::{Workshop, WorkshopError};

/// The variable that names a folder of packed kernels.
pub const VARIABLE: &str = "CELLRAY_KERNELS";

/// The names of the images in a pack: plain and scheduled.
const IMAGES: [&str; 2] = ["plain.elf", "scheduled.elf"];

/// The kernels' images and their sources.
#[derive(Clone, Debug)]
pub struct Kernels {
    /// The image of the plain kernels.
    pub plain: &'static [u8],
    /// The image of the scheduled kernels.
    pub scheduled: &'static [u8],
    /// The sources of the kernels.
    pub sources: Vec<Source>,
}

impl Kernels {
    /// The kernels of this repository, or those that [`VARIABLE`] names.
    pub fn here() -> Result<&'static Self, WorkshopError> {
        static KERNELS: OnceLock<Kernels> = OnceLock::new();
        static MAKING: Mutex<()> = Mutex::new(());
        let _one_at_a_time = MAKING.lock().unwrap_or_else(PoisonError::into_inner);
        if KERNELS.get().is_none() {
            let kernels = match pack() {
                Some(folder) => Self::unpacked(&folder)?,
                None => Self::made(&Workshop::here()?)?,
            };
            let _ = KERNELS.set(kernels);
        }
        Ok(KERNELS.get().expect("the kernels were set above"))
    }

    fn made(workshop: &Workshop) -> Result<Self, WorkshopError> {
        let sources = workshop.sources()?;
        let [plain, scheduled] = workshop.images(&sources)?;
        Ok(Self { plain: plain.leak(), scheduled: scheduled.leak(), sources })
    }

    fn unpacked(folder: &Path) -> Result<Self, WorkshopError> {
        let image = |name| {
            let path = folder.join(name);
            match fs::read(&path) {
                Ok(bytes) => Ok(&*bytes.leak()),
                Err(source) => Err(WorkshopError::File { path, source }),
            }
        };
        let [plain, scheduled] = IMAGES.map(image);
        let sources = Source::all(folder);
        Ok(Self {
            plain: plain?,
            scheduled: scheduled?,
            sources: sources.map_err(|(path, source)| WorkshopError::File { path, source })?,
        })
    }

    /// The source of the kernel with this name.
    #[must_use]
    pub fn source(&self, name: &str) -> Option<&Source> {
        self.sources.iter().find(|source| source.name == name)
    }
}

impl Source {
    /// The source of the kernel with this name in [`Kernels::here`].
    ///
    /// # Panics
    ///
    /// Panics if there are no kernels. Callers that can work without them check [`Kernels::here`]
    /// first.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static Self> {
        let kernels = Kernels::here().unwrap_or_else(|error| panic!("{error}"));
        kernels.source(name)
    }
}

/// The tracer's SPU program with any formulations, even if it is not shipped.
pub fn tracer(formulations: Formulations) -> Result<Vec<u8>, WorkshopError> {
    let Some(folder) = pack() else {
        return Workshop::here()?.tracer(formulations);
    };
    let path = folder.join(tracer_file(formulations));
    fs::read(&path).map_err(|source| WorkshopError::File { path, source })
}

/// Fills a folder with everything that a machine without sources or SPU assembler needs.
pub fn pack_into(folder: &Path) -> Result<(), WorkshopError> {
    let workshop = Workshop::here()?;
    let kernels = Kernels::made(&workshop)?;
    let put = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        let made = path.parent().map_or(Ok(()), fs::create_dir_all);
        made.and_then(|()| fs::write(&path, bytes))
            .map_err(|source| WorkshopError::File { path, source })
    };
    for source in &kernels.sources {
        put(source.file, source.text.as_bytes())?;
    }
    for (name, image) in IMAGES.iter().zip([kernels.plain, kernels.scheduled]) {
        put(name, image)?;
    }
    for sphere in SPHERES {
        for triangle in TRIANGLES {
            let formulations = Formulations::of(sphere, triangle);
            put(&tracer_file(formulations), &workshop.tracer(formulations)?)?;
        }
    }
    Ok(())
}

fn tracer_file(formulations: Formulations) -> String {
    format!("cellray-spu-{}.elf", formulations.name())
}

fn pack() -> Option<PathBuf> {
    std::env::var_os(VARIABLE).map(PathBuf::from)
}
