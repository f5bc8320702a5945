//! The picture, and the maps that can be laid over it.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use maud::{Markup, PreEscaped, html};

use crate::Inspection;
use crate::frame::{FrameTimes, TracedTile};
use crate::timelines::grouped;

/// The colours of the SPUs, here and in the timelines.
pub(crate) const SPU_COLOURS: [&str; 16] = [
    "#4e79a7", "#f28e2b", "#59a14f", "#e15759", "#b07aa1", "#76b7b2", "#edc948", "#ff9da7",
    "#9c755f", "#bab0ac", "#1f77b4", "#2ca02c", "#d62728", "#9467bd", "#8c564b", "#17becf",
];

/// One map: a figure for each tile.
struct Map {
    id: &'static str,
    name: &'static str,
    remark: String,
    colour: Colour,
    value: fn(&TracedTile) -> u64,
}

enum Colour {
    /// From dark (nothing) to light (the largest value).
    Scale,
    /// One colour for each SPU.
    Spu,
}

/// The part of the page with the picture.
pub(crate) fn section(inspection: &Inspection, times: &FrameTimes) -> Markup {
    let maps = maps();
    let encoded = STANDARD.encode(inspection.picture);
    let (width, height) = inspection.size;
    html! {
        section.maps {
            h2 { "The picture, and maps of its tiles" }
            input #map-none type="radio" name="map" checked;
            label for="map-none" { "picture" }
            @for map in &maps {
                input id={ "map-" (map.id) } type="radio" name="map";
                label for={ "map-" (map.id) } { (map.name) }
            }
            div.stage style={ "aspect-ratio:" (width) "/" (height) ";max-width:" (width) "px" } {
                img src={ "data:image/png;base64," (encoded) } width=(width) height=(height) alt="The traced picture";
                @for map in &maps { (overlay(inspection, times, map)) }
            }
            @for map in &maps { p class={ "remark for-" (map.id) } { (legend(map, times)) " " (map.remark) } }
            p.gap {
                "The SPUs count tests, node visits, rays and bounces for the whole frame and not by "
                "tile or pixel, so there are no maps of them; the sums are below."
            }
        }
    }
}

fn maps() -> Vec<Map> {
    vec![
        Map {
            id: "cycles",
            name: "cycles",
            remark: "Cycles that each tile took, waits included.".into(),
            colour: Colour::Scale,
            value: TracedTile::cycles,
        },
        Map {
            id: "waits",
            name: "waits",
            remark: "Cycles in which the SPU slept in a channel while it traced the tile.".into(),
            colour: Colour::Scale,
            value: |tile| tile.slept,
        },
        Map {
            id: "fetched",
            name: "bytes fetched",
            remark: "Bytes that the MFC brought into local store while the tile was traced. They \
                     may be for a later tile."
                .into(),
            colour: Colour::Scale,
            value: |tile| tile.fetched,
        },
        Map {
            id: "finished",
            name: "order",
            remark: "The cycle of the frame in which each tile was finished.".into(),
            colour: Colour::Scale,
            value: |tile| tile.end,
        },
        Map {
            id: "spu",
            name: "SPU",
            remark: "The SPU that traced each tile. SPUs take work units, runs of tiles, from a \
                     shared counter."
                .into(),
            colour: Colour::Spu,
            value: |tile| tile.spu as u64,
        },
    ]
}

fn colour(map: &Map, value: u64, most: u64) -> String {
    match map.colour {
        Colour::Spu => SPU_COLOURS[value as usize % SPU_COLOURS.len()].into(),
        Colour::Scale => {
            let part = value as f64 / most.max(1) as f64;
            format!(
                "#{:x}",
                colorous::INFERNO.eval_continuous(part.clamp(0.0, 1.0))
            )
        }
    }
}

fn most(map: &Map, times: &FrameTimes) -> u64 {
    times.tiles().map(map.value).max().unwrap_or(0)
}

fn overlay(inspection: &Inspection, times: &FrameTimes, map: &Map) -> Markup {
    let (width, height) = inspection.size;
    let (tile_width, tile_height) = inspection.tile_size;
    let across = width.div_ceil(tile_width).max(1);
    let most = most(map, times);
    let mut text = format!(
        "<svg class=\"overlay for-{}\" viewBox=\"0 0 {width} {height}\">",
        map.id
    );
    for tile in times.tiles() {
        let (x, y) = (
            tile.number % across * tile_width,
            tile.number / across * tile_height,
        );
        let size = (
            tile_width.min(width.saturating_sub(x)),
            tile_height.min(height.saturating_sub(y)),
        );
        let value = (map.value)(tile);
        // Writing to a string can't fail.
        let _ = write!(
            text,
            "<rect x=\"{x}\" y=\"{y}\" width=\"{}\" height=\"{}\" fill=\"{}\"><title>tile {}, SPU {}: {value}</title></rect>",
            size.0,
            size.1,
            colour(map, value, most),
            tile.number,
            tile.spu
        );
    }
    text.push_str("</svg>");
    PreEscaped(text)
}

fn legend(map: &Map, times: &FrameTimes) -> Markup {
    let most = most(map, times);
    html! {
        @match map.colour {
            Colour::Spu => @for spu in 0..times.spus.len() {
                span.swatch style={ "background:" (SPU_COLOURS[spu % SPU_COLOURS.len()]) } {}
                " " (spu) " "
            },
            Colour::Scale => {
                "0 "
                @for step in 0..=20u64 {
                    span.step style={ "background:" (colour(map, step, 20)) } {}
                }
                " " (grouped(most)) "."
            }
        }
    }
}
