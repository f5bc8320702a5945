//! A height field of a scene, its samples, and its views.
//!
//! Invariant: no samples and no view change while SPUs may read them.

use std::sync::Arc;

use glam::DVec3;
use scenes::{HeightField, HeightRegion};

use super::levels::{Levels, Packing};
use super::samples::HeightSamples;
use super::shades::{Shades, Sun};
use super::view::HeightView;
use crate::scene::colour::Colour;

/// A height field, and its views. These are used in turn, since those of the last pictures are
/// kept as long as they may be shown.
#[derive(Clone, Debug)]
pub(crate) struct HeightViews {
    field: Arc<HeightField>,
    packing: Arc<Packing>,
    /// All levels before they are packed, from the first change of the field on.
    levels: Option<Levels>,
    /// The samples. The first ones are up to date, and are those of the next view.
    versions: Vec<Version>,
    /// The origin of the boxes' coordinates.
    origin: DVec3,
    views: Vec<Arc<HeightView>>,
    /// The eye of the current view, the first one, and the light whose shadows it has.
    seen: Option<(DVec3, Option<u32>)>,
    /// The last light's direction.
    to_light: Option<DVec3>,
}

/// The samples of all levels, of which there are several once they change.
#[derive(Clone, Debug)]
struct Version {
    samples: Arc<HeightSamples>,
    /// Where they are not up to date.
    stale: HeightRegion,
}

impl HeightViews {
    /// Makes the samples of a height field.
    pub fn new(field: &Arc<HeightField>, origin: DVec3, colour: Colour) -> Self {
        let packing = Packing::new(colour);
        let samples = HeightSamples::new(field, &Levels::new(field, &packing), &packing);
        Self {
            field: field.clone(),
            packing: Arc::new(packing),
            levels: None,
            versions: vec![Version { samples: Arc::new(samples), stale: HeightRegion::default() }],
            origin,
            views: vec![Arc::new(HeightView::new())],
            seen: None,
            to_light: None,
        }
    }

    /// The box around it.
    pub fn bounds(&self) -> [DVec3; 2] {
        self.field.bounds().into()
    }

    /// Takes over a region of another height field of the same size.
    pub fn shape(&mut self, other: &HeightField, region: &HeightRegion) {
        let Self { field, packing, levels, versions, .. } = self;
        Arc::make_mut(field).shape(region, |[column, row], _| other.at(column, row));
        levels.get_or_insert_with(|| Levels::new(other, packing)).update(other, packing, region);
        for copy in versions.iter_mut() {
            copy.stale = copy.stale.with(region);
        }
        self.renew();
    }

    /// Makes samples the first ones that no picture has, and brings them up to date.
    fn renew(&mut self) -> Option<&mut HeightSamples> {
        let Self { field, packing, levels, versions, views, seen, .. } = self;
        for view in views.iter_mut().filter_map(Arc::get_mut) {
            view.rest();
        }
        *seen = None;
        let free = versions.iter_mut().position(|copy| Arc::get_mut(&mut copy.samples).is_some());
        let at = free.unwrap_or_else(|| {
            let Version { samples, stale } = &versions[0];
            let samples = Arc::new(HeightSamples::clone(samples));
            versions.push(Version { samples, stale: stale.clone() });
            versions.len() - 1
        });
        versions.swap(0, at);
        let Version { samples, stale } = &mut versions[0];
        let samples = Arc::get_mut(samples)?;
        let stale = std::mem::take(stale);
        if let Some(levels) = levels {
            samples.update(field, levels, packing, &stale);
        }
        if let Some(shades) = &mut samples.shades {
            shades.update(field, &stale);
        }
        Some(samples)
    }

    /// Whether the first samples have the shadows of a light. They get those of one that stays the
    /// same: where it moves all the time, they would be made for nothing.
    fn shine(&mut self, to_light: DVec3) -> bool {
        let stays = self.to_light.replace(to_light).is_none_or(|last| last == to_light);
        let sun = Sun::new(&self.field, to_light);
        let is_there = |samples: &HeightSamples| samples.shades.as_ref().map(|it| it.sun) == sun;
        if stays && !is_there(&self.versions[0].samples) {
            let field = self.field.clone();
            if let Some(samples) = self.renew() {
                samples.shades = sun.map(|sun| Shades::new(&field, sun));
            }
        }
        sun.is_some() && is_there(&self.versions[0].samples)
    }

    /// Makes the view of an eye the current one, with the shadows of a light: its number and the
    /// direction to it.
    pub fn look(&mut self, eye: DVec3, light: Option<(u32, DVec3)>) {
        let light = light.and_then(|(number, to)| self.shine(to).then_some(number));
        if self.seen == Some((eye, light)) {
            return;
        }
        self.seen = Some((eye, light));
        let unused = self.views.iter_mut().position(|view| Arc::get_mut(view).is_some());
        let at = unused.unwrap_or_else(|| {
            self.views.push(Arc::new(HeightView::new()));
            self.views.len() - 1
        });
        self.views.swap(0, at);
        if let Some(view) = Arc::get_mut(&mut self.views[0]) {
            view.look(&self.field, &self.versions[0].samples, eye, self.origin, light);
        }
    }

    /// The samples of the next view.
    #[cfg(test)]
    pub fn samples(&self) -> &HeightSamples {
        &self.versions[0].samples
    }

    /// How many views there are, and how many versions of the samples.
    #[cfg(test)]
    pub fn count(&self) -> [usize; 2] {
        [self.views.len(), self.versions.len()]
    }

    /// The current view.
    pub fn view(&self) -> &Arc<HeightView> {
        &self.views[0]
    }
}
