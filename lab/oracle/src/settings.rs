//! The settings of a picture: those that its file carries, those of the command line, and what is
//! assumed without them.
//!
//! Owns the names, which are those of the options of `cellray render`; `docs/play.md` lists
//! them. Invariant: what is assumed is what `cellray render` does without options.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use glam::DVec3;
use scenes::{Scene, View};

use crate::whitted::{self, Counts, MAX_DEPTH};
use crate::{Colour, Error, Pixels, Reference, Samples};

/// What the keyword of a setting begins with.
const PREFIX: &str = "cellray:";
/// The keyword of the program that made a picture.
const SOFTWARE: &str = "Software";

/// The settings that the reference follows, besides the scene.
const FOLLOWED: [&str; 16] = [
    "animation",
    "time",
    "from",
    "look-at",
    "up",
    "angle",
    "model",
    "ray-depth",
    "fresnel",
    "spd-rays",
    "no-shadows",
    "antialias",
    "contrast",
    "colour",
    "roll-off",
    "corners",
];
/// The settings that the reference has no use for: they choose among kernels, which all mean the
/// same.
const OF_KERNELS: [&str; 5] = ["quality", "sphere", "triangle", "program", "shader"];

/// Settings of a picture by their names, which are those of options without the hyphens.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Settings {
    values: BTreeMap<String, String>,
    software: Option<String>,
    scene: Option<String>,
}

/// How a picture is made of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Model {
    /// Depth shading.
    Depth(Pixels),
    /// Whitted's model.
    Whitted(whitted::Options),
}

impl Settings {
    /// The settings that a PNG file carries.
    ///
    /// # Errors
    /// The file can't be read, or is no PNG.
    pub fn of_png(path: &Path) -> Result<Self, Error> {
        let failed =
            |error: std::io::Error| Error::Png { path: path.to_owned(), source: error.into() };
        let file = File::open(path).map_err(failed)?;
        let decoder = png::Decoder::new(BufReader::new(file));
        let mut reader = decoder.read_info().map_err(|error| failed(error.into()))?;
        // Text may come after the pixels. Whoever decodes these reports what is wrong with them.
        let _ = reader.finish();
        let info = reader.info();
        let latin = info.uncompressed_latin1_text.iter();
        let latin = latin.map(|text| (text.keyword.as_str(), text.text.clone()));
        let unicode = info.utf8_text.iter().filter_map(|text| {
            let value = text.get_text().ok()?;
            Some((text.keyword.as_str(), value))
        });
        let mut settings = Self::default();
        for (keyword, value) in latin.chain(unicode) {
            match keyword.strip_prefix(PREFIX) {
                Some("scene") => settings.scene = Some(value),
                Some(name) => settings.set(name, value),
                None if keyword == SOFTWARE => settings.software = Some(value),
                None => {}
            }
        }
        Ok(settings)
    }

    /// Sets one, by its option's name.
    pub fn set(&mut self, name: &str, value: impl ToString) {
        self.values.insert(name.to_owned(), value.to_string());
    }

    /// Sets the scene, and the program that makes the picture.
    pub fn set_scene(&mut self, scene: &str, software: &str) {
        self.scene = Some(scene.to_owned());
        self.software = Some(software.to_owned());
    }

    /// Keywords and texts for a PNG file.
    pub(crate) fn texts(&self) -> impl Iterator<Item = (String, String)> {
        let keyed = |(name, value): (&str, &String)| (format!("{PREFIX}{name}"), value.clone());
        let software = self.software.iter().map(|text| (SOFTWARE.to_owned(), text.clone()));
        let scene = self.scene.iter().map(move |text| keyed(("scene", text)));
        let values = self.values.iter().map(move |(name, value)| keyed((name, value)));
        software.chain(scene).chain(values)
    }

    /// The program that made the picture, and its version.
    #[must_use]
    pub fn software(&self) -> Option<&str> {
        self.software.as_deref()
    }

    /// The picture's scene, as it was named.
    #[must_use]
    pub fn scene(&self) -> Option<&str> {
        self.scene.as_deref()
    }

    /// The settings that the reference follows, as options.
    #[must_use]
    pub fn followed(&self) -> Vec<String> {
        self.options(|name| FOLLOWED.contains(&name))
    }

    /// The settings that choose kernels, as options.
    #[must_use]
    pub fn of_kernels(&self) -> Vec<String> {
        self.options(|name| OF_KERNELS.contains(&name))
    }

    /// The settings that this version does not support, as options.
    #[must_use]
    pub fn unknown(&self) -> Vec<String> {
        self.options(|name| !FOLLOWED.contains(&name) && !OF_KERNELS.contains(&name))
    }

    fn options(&self, is_wanted: impl Fn(&str) -> bool) -> Vec<String> {
        let wanted = self.values.iter().filter(|(name, _)| is_wanted(name));
        let option = |(name, value): (&String, &String)| match value.as_str() {
            "true" => format!("--{name}"),
            "false" => format!("--{name}=false"),
            value => format!("--{name} {}", value.escape_debug()),
        };
        wanted.map(option).collect()
    }

    /// Those of these settings that `over` does not have.
    #[must_use]
    pub fn without(&self, over: &Self) -> Self {
        let mut left = self.clone();
        left.values.retain(|name, _| !over.values.contains_key(name));
        left
    }

    /// These settings, and those of `under` that these do not have.
    #[must_use]
    pub fn over(&self, under: &Self) -> Self {
        let mut all = under.clone();
        all.values.extend(self.values.clone());
        all
    }

    /// What is assumed of a scene's picture where nothing is set.
    #[must_use]
    pub fn assumed(&self, scene: &Scene) -> Self {
        let mut assumed = Self::default();
        let mut assume = |name, value: &dyn ToString| {
            if !self.values.contains_key(name) {
                assumed.set(name, value.to_string());
            }
        };
        let of_scene = if scene.lights.is_empty() { "depth" } else { "whitted" };
        assume("model", &of_scene);
        let model = self.values.get("model").map_or(of_scene, String::as_str);
        let is_whitted = model == "whitted";
        let has_corners = self.values.get("corners").is_some_and(|value| value == "true");
        if is_whitted {
            assume("ray-depth", &whitted::Options::default().depth);
        }
        assume("antialias", if has_corners { &1 } else { &4 });
        if self.values.get("antialias").map_or(!has_corners, |value| value != "1") {
            assume("contrast", &32);
        }
        let colour = match is_whitted && !has_corners {
            true => "srgb",
            false => "linear",
        };
        assume("colour", &colour);
        assumed
    }

    /// The name or number of the scene's animation, if it has been chosen.
    #[must_use]
    pub fn animation(&self) -> Option<&str> {
        self.values.get("animation").map(String::as_str)
    }

    /// The time of the animation in seconds, if it plays.
    ///
    /// # Errors
    /// The setting is no number. `path` is the file that the error names.
    pub fn time(&self, path: &Path) -> Result<Option<f64>, Error> {
        self.get("time", path, "a finite number", number)
    }

    /// Changes a view to that of the picture.
    ///
    /// # Errors
    /// A setting means nothing. `path` is the file that the error names.
    pub fn place(&self, view: &mut View, path: &Path) -> Result<(), Error> {
        let three = "three finite numbers with commas between";
        let triple = |text: &str| {
            let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
            <[f64; 3]>::try_from(numbers?).ok().map(DVec3::from)
        };
        let View { from, at, up, angle, .. } = view;
        for (name, to) in [("from", from), ("look-at", at), ("up", up)] {
            *to = self.get(name, path, three, triple)?.unwrap_or(*to);
        }
        *angle = self.get("angle", path, "a finite number", number)?.unwrap_or(*angle);
        Ok(())
    }

    /// The model, if nothing needs to be assumed.
    ///
    /// # Errors
    /// A setting means nothing. `path` is the file that the error names.
    pub fn model(&self, path: &Path) -> Result<Model, Error> {
        let flag = |name| {
            let read = |text: &str| text.parse::<bool>().ok();
            let value = self.get(name, path, "true or false", read)?;
            Ok::<_, Error>(value.unwrap_or(false))
        };
        let samples = |text: &str| match text {
            "1" => Some(Samples::One),
            "4" => Some(Samples::Four),
            "16" => Some(Samples::Sixteen),
            _ => None,
        };
        let contrast = |text: &str| text.parse::<u8>().ok();
        let colour = |text: &str| match text {
            "linear" => Some(Colour::Linear),
            "srgb" => Some(Colour::Srgb),
            _ => None,
        };
        let plain = Pixels::PLAIN;
        let pixels = Pixels {
            samples: self.get("antialias", path, "1, 4 or 16", samples)?.unwrap_or(plain.samples),
            contrast: self
                .get("contrast", path, "a whole number from 0 to 255", contrast)?
                .unwrap_or(plain.contrast),
            colour: self.get("colour", path, "linear or srgb", colour)?.unwrap_or(plain.colour),
            roll_off: flag("roll-off")?,
            corners: flag("corners")?,
        };
        let depth = |text: &str| text.parse().ok().filter(|depth| (1..=MAX_DEPTH).contains(depth));
        let options = whitted::Options {
            depth: self
                .get("ray-depth", path, "a whole number from 1 to 16", depth)?
                .unwrap_or(whitted::Options::default().depth),
            fresnel: flag("fresnel")?,
            spd_rays: flag("spd-rays")?,
            shadows: !flag("no-shadows")?,
            pixels,
            rounding: whitted::Rounding::Double,
        };
        let model = |text: &str| match text {
            "depth" => Some(Model::Depth(pixels)),
            "whitted" => Some(Model::Whitted(options)),
            _ => None,
        };
        let model = self.get("model", path, "depth or whitted", model)?;
        Ok(model.unwrap_or(Model::Whitted(options)))
    }

    fn get<T>(
        &self,
        name: &'static str,
        path: &Path,
        expected: &'static str,
        read: impl FnOnce(&str) -> Option<T>,
    ) -> Result<Option<T>, Error> {
        let Some(value) = self.values.get(name) else {
            return Ok(None);
        };
        let read = read(value).ok_or_else(|| Error::Setting {
            path: path.to_owned(),
            name,
            value: value.clone(),
            expected,
        });
        read.map(Some)
    }
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|number: &f64| number.is_finite())
}

impl Model {
    /// How pixels are made.
    #[must_use]
    pub fn pixels(&self) -> &Pixels {
        match self {
            Self::Depth(pixels) => pixels,
            Self::Whitted(options) => &options.pixels,
        }
    }

    /// Renders a scene. Whitted's model counts its rays.
    ///
    /// # Errors
    /// As for [`crate::trace`] and [`whitted::trace`].
    pub fn trace(
        &self,
        scene: &Scene,
        (width, height): (u32, u32),
    ) -> Result<(Reference, Option<Counts>), Error> {
        match self {
            Self::Depth(pixels) => {
                let reference = crate::trace_with(scene, width, height, pixels)?;
                Ok((reference, None))
            }
            Self::Whitted(options) => {
                let (reference, counts) = whitted::trace(scene, width, height, options)?;
                Ok((reference, Some(counts)))
            }
        }
    }
}
