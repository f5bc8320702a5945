//! The picture, and the maps that can be laid over it.

use std::fmt::Write as _;
use std::io::Cursor;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use colorous::Color;
use image::{ImageFormat, Rgb, RgbImage};
use maud::{Markup, PreEscaped, html};

use crate::frame::{FrameTimes, TracedTile};
use crate::timelines::grouped;
use crate::{InspectError, Inspection, PixelMap, TileMap};

/// The colours of the SPUs, here and in the timelines.
pub(crate) const SPU_COLOURS: [&str; 16] = [
    "#4e79a7", "#f28e2b", "#59a14f", "#e15759", "#b07aa1", "#76b7b2", "#edc948", "#ff9da7",
    "#9c755f", "#bab0ac", "#1f77b4", "#2ca02c", "#d62728", "#9467bd", "#8c564b", "#17becf",
];

/// One map: a figure for each tile.
struct Map<'a> {
    id: &'static str,
    name: &'static str,
    remark: &'a str,
    colour: Colour,
    value: Value<'a>,
}

type Value<'a> = Box<dyn Fn(&TracedTile) -> u64 + 'a>;

enum Colour {
    /// From dark (nothing) to light (the largest value).
    Scale,
    /// One colour for each SPU.
    Spu,
}

/// The part of the page with the picture.
pub(crate) fn section(inspection: &Inspection, times: &FrameTimes) -> Result<Markup, InspectError> {
    let maps = maps(inspection.tile_maps);
    let by_pixel = inspection.pixel_maps;
    let (width, height) = inspection.size;
    let ids = maps.iter().map(|map| (map.id, map.name));
    let ids: Vec<_> = ids.chain(by_pixel.iter().map(|map| (map.id, map.name))).collect();
    let pictures = by_pixel.iter().map(|map| pixels(map, inspection.size));
    let pictures = pictures.collect::<Result<Vec<_>, _>>()?;
    Ok(html! {
        style { (PreEscaped(ids.iter().map(|(id, _)| shown(id)).collect::<String>())) }
        section.maps {
            h2 { "The picture, and maps of its tiles and pixels" }
            label { input #map-none type="radio" name="map" checked; " picture" }
            @for (id, name) in &ids {
                " "
                label { input id={ "map-" (id) } type="radio" name="map"; " " (name) }
            }
            div.stage style={ "aspect-ratio:" (width) "/" (height) ";max-width:" (width) "px" } {
                img src=(data(inspection.picture)) width=(width) height=(height) alt="The traced picture";
                @for map in &maps { (overlay(inspection, times, map)) }
                @for (map, picture) in by_pixel.iter().zip(&pictures) {
                    img class={ "overlay for-" (map.id) } src=(data(picture)) alt={ "The map of " (map.name) };
                }
            }
            @for map in &maps { p class={ "remark for-" (map.id) } { (legend(map, times)) " " (map.remark) } }
            @for map in by_pixel {
                p class={ "remark for-" (map.id) } {
                    (pixel_legend(map)) " " (map.remark)
                }
            }
        }
    })
}

/// The rules by which a map is shown while its button is pressed.
fn shown(id: &str) -> String {
    format!(".maps:has(#map-{id}:checked) .for-{id} {{ display: block }}\n")
}

/// A picture within the page.
fn data(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}

/// A map of the pixels as the bytes of a PNG file.
fn pixels(map: &PixelMap, (width, height): (u32, u32)) -> Result<Vec<u8>, image::ImageError> {
    let most = u64::from(map.values.iter().copied().max().unwrap_or(0));
    let picture = RgbImage::from_fn(width, height, |x, y| {
        let at = y as usize * width as usize + x as usize;
        let value = map.values.get(at).copied().unwrap_or(0);
        let Color { r, g, b } = pixel_colour(map, value, most);
        Rgb([r, g, b])
    });
    let mut bytes = Vec::new();
    picture.write_to(&mut Cursor::new(&mut bytes), ImageFormat::Png)?;
    Ok(bytes)
}

fn maps(more: &[TileMap]) -> Vec<Map<'_>> {
    let own: [(_, _, _, _, Value<'_>); 5] = [
        (
            "cycles",
            "cycles",
            "Cycles that each tile took, waits included.",
            Colour::Scale,
            Box::new(TracedTile::cycles),
        ),
        (
            "waits",
            "waits",
            "Cycles in which the SPU slept in a channel while it traced the tile.",
            Colour::Scale,
            Box::new(|tile| tile.slept),
        ),
        (
            "fetched",
            "bytes fetched",
            "Bytes that the MFC brought into local store while the tile was traced. They may be for \
             a later tile.",
            Colour::Scale,
            Box::new(|tile| tile.fetched),
        ),
        (
            "finished",
            "order",
            "The cycle of the frame in which each tile was finished.",
            Colour::Scale,
            Box::new(|tile| tile.end),
        ),
        (
            "spu",
            "SPU",
            "The SPU that traced each tile. SPUs take work units, runs of tiles, from a shared \
             counter.",
            Colour::Spu,
            Box::new(|tile| tile.spu as u64),
        ),
    ];
    let own = own.into_iter().map(|(id, name, remark, colour, value)| Map {
        id,
        name,
        remark,
        colour,
        value,
    });
    let more = more.iter().map(|map| Map {
        id: map.id,
        name: map.name,
        remark: map.remark,
        colour: Colour::Scale,
        value: Box::new(|tile| map.values.get(tile.number as usize).copied().unwrap_or(0)),
    });
    own.chain(more).collect()
}

/// The colour of a value on the scale up to the largest one.
fn heat(value: u64, most: u64) -> Color {
    let part = value as f64 / most.max(1) as f64;
    colorous::INFERNO.eval_continuous(part.clamp(0.0, 1.0))
}

/// The colour of a value of a map of pixels.
fn pixel_colour(map: &PixelMap, value: u8, most: u64) -> Color {
    match map.kinds {
        [] => heat(u64::from(value), most),
        kinds => heat(u64::from(value), kinds.len() as u64),
    }
}

/// The colours of a map of pixels: of kinds with the share of the picture that each has.
fn pixel_legend(map: &PixelMap) -> Markup {
    let share = |kind: usize| {
        let of_kind = map.values.iter().filter(|value| usize::from(**value) == kind).count();
        100.0 * of_kind as f64 / map.values.len().max(1) as f64
    };
    if map.kinds.is_empty() {
        return scale(u64::from(map.values.iter().copied().max().unwrap_or(0)));
    }
    html! {
        @for (kind, name) in map.kinds.iter().enumerate().filter(|(kind, _)| share(*kind) > 0.0) {
            span.swatch style=(format!("background:#{:x}", pixel_colour(map, kind as u8, 0))) {}
            " " (name) " " (format!("({:.1} %)", share(kind))) ". "
        }
    }
}

fn colour(map: &Map, value: u64, most: u64) -> String {
    match map.colour {
        Colour::Spu => SPU_COLOURS[value as usize % SPU_COLOURS.len()].into(),
        Colour::Scale => format!("#{:x}", heat(value, most)),
    }
}

fn most(map: &Map, times: &FrameTimes) -> u64 {
    times.tiles().map(&map.value).max().unwrap_or(0)
}

fn overlay(inspection: &Inspection, times: &FrameTimes, map: &Map) -> Markup {
    let (width, height) = inspection.size;
    let (tile_width, tile_height) = inspection.tile_size;
    let across = width.div_ceil(tile_width).max(1);
    let most = most(map, times);
    let mut text =
        format!("<svg class=\"overlay for-{}\" viewBox=\"0 0 {width} {height}\">", map.id);
    for tile in times.tiles() {
        let (x, y) = (tile.number % across * tile_width, tile.number / across * tile_height);
        let size =
            (tile_width.min(width.saturating_sub(x)), tile_height.min(height.saturating_sub(y)));
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
    match map.colour {
        Colour::Spu => html! {
            @for spu in 0..times.spus.len() {
                span.swatch style={ "background:" (SPU_COLOURS[spu % SPU_COLOURS.len()]) } {}
                " " (spu) " "
            }
        },
        Colour::Scale => scale(most(map, times)),
    }
}

/// The colours from 0 to the largest value.
fn scale(most: u64) -> Markup {
    if most == 0 {
        return html! { "0 everywhere." };
    }
    html! {
        "0 "
        @for step in 0..=20u64 {
            span.step style=(format!("background:#{:x}", heat(step, 20))) {}
        }
        " " (grouped(most)) "."
    }
}
