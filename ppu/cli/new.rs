//! `cellray new`: a folder with a game that is a crate of its own.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use clap::{Args, ValueEnum};

use super::Outcome;

/// The sources that this program was built from.
const SOURCES: &str = env!("CARGO_MANIFEST_DIR");
/// The versions of other crates with which cellray is tested, which a new game keeps.
const LOCK: &str = include_str!("../../Cargo.lock");
/// How a game's build optimises each crate.
const PROFILE: &str = include_str!("new/profile.toml");

/// A game to begin with: one of the tutorial's, whose files the links in `new/` lead to.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Template {
    /// A ball that jumps
    #[default]
    Ball,
    /// A ball to steer over a mirror, with a recorded session
    Steer,
    /// A planet with a shader of its own; needs an SPU assembler
    Stripes,
}

impl Template {
    /// Its files, by their paths in the game's folder.
    fn files(self) -> &'static [(&'static str, &'static [u8])] {
        match self {
            Self::Ball => &[("src/main.rs", include_bytes!("new/ball.rs"))],
            Self::Steer => &[
                ("src/main.rs", include_bytes!("new/steer.rs")),
                ("played.session", include_bytes!("new/played.session")),
            ],
            Self::Stripes => &[
                ("src/main.rs", include_bytes!("new/stripes.rs")),
                ("build.rs", include_bytes!("new/build.rs")),
                ("shaders/stripes.s", include_bytes!("new/stripes.s")),
            ],
        }
    }

    /// The crates of cellray that it depends on, by the parts of its manifest.
    fn crates(self) -> &'static [(&'static str, &'static [Crate])] {
        match self {
            Self::Ball | Self::Steer => &[("dependencies", GAME)],
            Self::Stripes => &[("dependencies", GAME), ("build-dependencies", BUILD)],
        }
    }
}

const GAME: &[Crate] = &[
    Crate {
        name: "cellray",
        folder: "",
        // Without what only the program `cellray` needs.
        features: ", default-features = false",
    },
    Crate { name: "cellray-play", folder: "play", features: "" },
];
const BUILD: &[Crate] = &[Crate { name: "spu-build", folder: "linker", features: "" }];

/// A crate of cellray as a dependency.
struct Crate {
    name: &'static str,
    /// Its folder in cellray's sources.
    folder: &'static str,
    /// The features of the dependency, as the end of its entry in the manifest.
    features: &'static str,
}

/// Create a folder with a game of your own, ready to run.
#[derive(Args)]
pub struct Arguments {
    /// Folder to create; its name becomes the game's
    folder: PathBuf,
    /// Game to begin with
    #[arg(long, value_enum, default_value_t)]
    template: Template,
    /// Folder of the cellray sources that the game depends on [default: this program's]
    ///
    /// The default is the repository from which this program's sources were cloned if they are
    /// unchanged, otherwise their folder.
    #[arg(long, value_name = "FOLDER", conflicts_with = "git")]
    path: Option<PathBuf>,
    /// Git repository of the cellray sources that the game depends on
    #[arg(long, value_name = "ADDRESS")]
    git: Option<String>,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let folder = &arguments.folder;
    let name = package_name(folder)?;
    let manifest = format!(
        "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\n{}\n{PROFILE}",
        arguments.dependencies()?
    );
    let written = [
        ("Cargo.toml", manifest.as_bytes()),
        ("Cargo.lock", LOCK.as_bytes()),
        (".gitignore", b"/target\n".as_slice()),
    ];
    fs::create_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for (file, bytes) in written.iter().chain(arguments.template.files()) {
        let path = folder.join(file);
        let made = path.parent().map_or(Ok(()), fs::create_dir_all);
        made.and_then(|()| fs::write(&path, bytes))
            .map_err(|error| format!("{}: {error}", path.display()))?;
    }
    messages::print!(
        "cellray: made {0}; next: cd {0} && cargo run --release (the first build takes minutes)",
        folder.display()
    );
    Ok(())
}

impl Arguments {
    /// The parts of the manifest that name cellray's crates.
    fn dependencies(&self) -> Result<String, String> {
        let origin = self.origin()?;
        let mut text = String::new();
        for (part, crates) in self.template.crates() {
            text += &format!("\n[{part}]\n");
            for Crate { name, folder, features } in *crates {
                let place = origin.dependency(folder)?;
                text += &format!("{name} = {{ {place}{features} }}\n");
            }
        }
        Ok(text)
    }

    /// Where cellray's crates are taken from.
    fn origin(&self) -> Result<Origin, String> {
        if let Some(address) = &self.git {
            return Ok(Origin::Git(address.clone(), None));
        }
        if let Some(path) = &self.path {
            return Ok(Origin::Folder(path.clone()));
        }
        let sources = PathBuf::from(SOURCES);
        Ok(match published(&sources) {
            Some((address, commit)) => Origin::Git(address, Some(commit)),
            None => Origin::Folder(sources),
        })
    }
}

/// Where a game takes cellray's crates from.
enum Origin {
    /// A folder of this machine.
    Folder(PathBuf),
    /// A repository, and a commit of it; without one, its newest.
    Git(String, Option<String>),
}

impl Origin {
    /// The dependency on the crate in this folder of cellray's sources.
    fn dependency(&self, folder: &str) -> Result<String, String> {
        let sources = match self {
            Self::Folder(sources) => sources,
            Self::Git(address, None) => return Ok(format!("git = {}", toml_string(address)?)),
            Self::Git(address, Some(commit)) => {
                return Ok(format!(
                    "git = {}, rev = {}",
                    toml_string(address)?,
                    toml_string(commit)?
                ));
            }
        };
        let path = fs::canonicalize(sources.join(folder))
            .ok()
            .filter(|path| path.join("Cargo.toml").is_file());
        let path = path.ok_or_else(|| {
            format!(
                "{}: cellray's sources are not there; name their folder by --path or their \
                 repository by --git",
                sources.display()
            )
        })?;
        match path.to_str() {
            Some(path) => Ok(format!("path = {}", toml_string(path)?)),
            None => Err(format!("{}: the path is not UTF-8", path.display())),
        }
    }
}

/// The repository that these sources were cloned from, and their commit, if others can fetch from
/// there just what is here. A game that names them builds on other machines, too.
fn published(sources: &Path) -> Option<(String, String)> {
    let git = |arguments: &[&str]| {
        let mut command = Command::new("git");
        let output = command.arg("-C").arg(sources).args(arguments).output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        output.status.success().then(|| text.trim().to_owned())
    };
    let address = address(&git(&["remote", "get-url", "origin"])?)?;
    let is_changed = !git(&["status", "--porcelain", "--untracked-files=no"])?.is_empty();
    let is_there = !git(&["branch", "--remotes", "--contains", "HEAD"])?.is_empty();
    (is_there && !is_changed).then_some((address, git(&["rev-parse", "HEAD"])?))
}

/// A repository's address in the form that cargo takes, unless it is a place on this machine.
fn address(remote: &str) -> Option<String> {
    match remote.split_once("://") {
        Some(("https" | "http" | "ssh" | "git", _)) => Some(remote.to_owned()),
        Some(_) => None,
        // git's short form of an address by ssh: user@host:path.
        None => {
            let (host, path) = remote.split_once(':')?;
            (host.contains('@') && !host.contains('/')).then(|| format!("ssh://{host}/{path}"))
        }
    }
}

/// A folder's name, if cargo takes it as a package's.
fn package_name(folder: &Path) -> Result<&str, String> {
    let name = folder.file_name().and_then(|name| name.to_str());
    let name = name.ok_or_else(|| format!("{}: not a folder's name", folder.display()))?;
    let is_first = |first: char| first.is_ascii_alphabetic() || first == '_';
    let is_other = |other: char| other.is_ascii_alphanumeric() || other == '_' || other == '-';
    if name.starts_with(is_first) && name.chars().all(is_other) {
        Ok(name)
    } else {
        Err(format!(
            "{name}: a package's name has letters, digits, - and _, and begins with a letter or _"
        ))
    }
}

/// A string in TOML's quotes.
fn toml_string(text: &str) -> Result<String, String> {
    if text.chars().any(char::is_control) {
        return Err(format!("{text:?}: no address or path has control characters"));
    }
    let quoted = text.replace('\\', "\\\\").replace('"', "\\\"");
    Ok(format!("\"{quoted}\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_package_names() {
        assert_eq!(package_name(Path::new("/tmp/my-game")), Ok("my-game"));
        assert!(package_name(Path::new("2d")).is_err());
        assert!(package_name(Path::new("a game")).is_err());
        assert!(package_name(Path::new("..")).is_err());
    }

    #[test]
    fn game_names_its_source_repository() {
        let folder = tempfile::tempdir().unwrap();
        let (clone, commit) = (folder.path().join("clone"), ["commit", "-q", "-m", "changed"]);
        let git = |arguments: &[&str]| {
            let mut command = Command::new("git");
            command.arg("-C").arg(&clone);
            for setting in ["user.name=a", "user.email=a", "commit.gpgsign=false"] {
                command.args(["-c", setting]);
            }
            assert!(command.args(arguments).status().unwrap().success());
        };
        fs::create_dir(&clone).unwrap();
        git(&["init", "-q"]);
        fs::write(clone.join("file"), "1").unwrap();
        git(&["add", "file"]);
        git(&commit);
        assert_eq!(published(&clone), None, "there is no remote");
        git(&["remote", "add", "origin", "https://example.org/cellray"]);
        assert_eq!(published(&clone), None, "the remote may not have it");
        git(&["update-ref", "refs/remotes/origin/main", "HEAD"]);
        let (address, commit_there) = published(&clone).unwrap();
        assert_eq!(address, "https://example.org/cellray");
        assert_eq!(commit_there.len(), 40);
        fs::write(clone.join("file"), "2").unwrap();
        assert_eq!(published(&clone), None, "a file is changed");
        git(&["add", "file"]);
        git(&commit);
        assert_eq!(published(&clone), None, "a commit is new");
    }

    #[test]
    fn addresses_are_accepted_as_by_cargo() {
        let there = |remote| address(remote);
        assert_eq!(there("ssh://a@b/c").as_deref(), Some("ssh://a@b/c"));
        assert_eq!(
            there("git@example.org:cellray.git").as_deref(),
            Some("ssh://git@example.org/cellray.git")
        );
        for here in ["/home/me/cellray", "../cellray", "file:///home/me/cellray", "/a@b:c"] {
            assert_eq!(there(here), None, "{here}");
        }
    }

    #[test]
    fn strings_are_quoted() {
        assert_eq!(toml_string(r#"a"b\c"#).as_deref(), Ok(r#""a\"b\\c""#));
        assert!(toml_string("a\nb").is_err());
    }
}
