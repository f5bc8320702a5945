//! The pictures of walls, floors and ceilings.
//!
//! A picture of a wall is put together from patches: columns of posts, which are runs of texels,
//! with holes between them. A picture of a floor is a flat: 64 by 64 texels.

use std::collections::HashMap;

use zerocopy::little_endian::{I16, U16, U32};
use zerocopy::{FromBytes, Immutable, KnownLayout, Unaligned};

use crate::{Error, Name, Sprite, Wad};

/// Texels across and down of a flat.
pub(crate) const FLAT: usize = 64;
/// The most texels across and down of a wall's picture, or of a patch.
const MAX_SIDE: usize = 4096;
/// The most texels of all patches of a picture: they may cover one another, but not without end.
const MAX_TEXELS: usize = 1 << 24;
/// The bytes of a palette: red, green and blue of each colour.
const PALETTE: usize = 768;

/// A picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Texels across.
    pub width: usize,
    /// Red, green and blue for a screen, row by row from the top; `None` in a hole.
    pub texels: Vec<Option<[u8; 3]>>,
}

impl Picture {
    /// Texels down.
    #[must_use]
    pub fn height(&self) -> usize {
        self.texels.len().checked_div(self.width).unwrap_or_default()
    }

    /// Its texels, with those in holes as one next to them: they are mixed with one another.
    pub(crate) fn filled(&self) -> Vec<[u8; 3]> {
        let mut texels = self.texels.clone();
        let of_texels = |(at, texel): (usize, &Option<_>)| texel.is_some().then_some(at);
        let mut known: Vec<usize> = texels.iter().enumerate().filter_map(of_texels).collect();
        let mut next = 0;
        while let Some(&at) = known.get(next) {
            next += 1;
            let (column, last) = (at % self.width, self.width - 1);
            let beside = [
                (column > 0).then(|| at - 1),
                (column < last).then_some(at + 1),
                at.checked_sub(self.width),
                Some(at + self.width),
            ];
            for other in beside.into_iter().flatten() {
                if texels.get(other) == Some(&None) {
                    texels[other] = texels[at];
                    known.push(other);
                }
            }
        }
        texels.into_iter().map(Option::unwrap_or_default).collect()
    }

    /// Whether there are holes.
    #[must_use]
    pub fn has_holes(&self) -> bool {
        self.texels.iter().any(Option::is_none)
    }
}

/// Pictures by their names.
pub trait Pictures {
    /// The picture of a wall; `None` if no wall's has this name.
    ///
    /// # Errors
    /// The picture is damaged.
    fn wall(&self, name: Name) -> Result<Option<Picture>, Error>;

    /// The picture of a floor or a ceiling; `None` if no flat has this name.
    ///
    /// # Errors
    /// The picture is damaged.
    fn flat(&self, name: Name) -> Result<Option<Picture>, Error>;

    /// The picture of a thing; `None` if no thing's has this name.
    ///
    /// # Errors
    /// The picture is damaged.
    fn sprite(&self, name: Name) -> Result<Option<Sprite>, Error>;
}

#[derive(FromBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct TextureRecord {
    name: [u8; 8],
    masked: U32,
    width: U16,
    height: U16,
    directory: U32,
    patches: U16,
}

#[derive(FromBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct PatchRecord {
    x: I16,
    y: I16,
    patch: U16,
    step: U16,
    colours: U16,
}

#[derive(FromBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct PatchHeader {
    width: U16,
    height: U16,
    left: I16,
    top: I16,
}

/// How a wall's picture is put together.
struct Composition<'a> {
    width: usize,
    height: usize,
    patches: &'a [PatchRecord],
}

/// The pictures of a WAD file.
pub struct Graphics<'a> {
    wad: &'a Wad,
    palette: &'a [u8],
    patches: &'a [[u8; 8]],
    textures: HashMap<Name, Composition<'a>>,
}

/// A patch's header, and where its columns are.
type Columns<'a> = (&'a PatchHeader, &'a [U32]);

/// A list in a lump: its count, and what follows.
fn counted(lump: &[u8]) -> Option<(usize, &[u8])> {
    let (count, rest) = U32::ref_from_prefix(lump).ok()?;
    Some((count.get() as usize, rest))
}

impl<'a> Graphics<'a> {
    /// Reads the palette and the lists of textures.
    ///
    /// # Errors
    /// One of these lumps is missing or too short, or a texture has no size or is too large.
    pub fn read(wad: &'a Wad) -> Result<Self, Error> {
        let needed = |name: &str| {
            let lump = wad.lump(Name::new(name));
            lump.ok_or_else(|| wad.wrong_lump(name, "it is missing".to_owned()))
        };
        let palette = needed("PLAYPAL")?;
        if palette.len() < PALETTE {
            let what = format!("{} bytes are less than the {PALETTE} of a palette", palette.len());
            return Err(wad.wrong_lump("PLAYPAL", what));
        }
        let names = needed("PNAMES")?;
        let patches = counted(names).and_then(|(count, rest)| {
            Some(<[[u8; 8]]>::ref_from_prefix_with_elems(rest, count).ok()?.0)
        });
        let patches = patches.ok_or_else(|| {
            let what = format!("{} bytes are too few for its list of names", names.len());
            wad.wrong_lump("PNAMES", what)
        })?;
        let mut graphics = Self { wad, palette, patches, textures: HashMap::new() };
        graphics.list("TEXTURE1", needed("TEXTURE1")?)?;
        if let Some(lump) = wad.lump(Name::new("TEXTURE2")) {
            graphics.list("TEXTURE2", lump)?;
        }
        Ok(graphics)
    }

    /// Adds the textures of a list.
    fn list(&mut self, name: &str, lump: &'a [u8]) -> Result<(), Error> {
        let wrong = |what| self.wad.wrong_lump(name, what);
        let size = lump.len();
        let offsets = counted(lump).and_then(|(count, rest)| {
            Some(<[U32]>::ref_from_prefix_with_elems(rest, count).ok()?.0)
        });
        let Some(offsets) = offsets else {
            return Err(wrong(format!("{size} bytes are too few for its list of textures")));
        };
        for (number, offset) in offsets.iter().enumerate() {
            let record = lump.get(offset.get() as usize..).and_then(|rest| {
                let (record, rest) = TextureRecord::ref_from_prefix(rest).ok()?;
                let count = usize::from(record.patches.get());
                let (patches, _) = <[PatchRecord]>::ref_from_prefix_with_elems(rest, count).ok()?;
                Some((record, patches))
            });
            let Some((record, patches)) = record else {
                let what = format!("texture {number} at byte {offset} is not within {size} bytes");
                return Err(wrong(what));
            };
            let name = Name::of(record.name);
            let [width, height] = [record.width, record.height].map(|side| usize::from(side.get()));
            if ![width, height].iter().all(|side| (1..=MAX_SIDE).contains(side)) {
                let what = format!(
                    "texture {name} has {width} by {height} texels; each must be from 1 to {MAX_SIDE}"
                );
                return Err(wrong(what));
            }
            // Of textures with the same name, games take the first.
            self.textures.entry(name).or_insert(Composition { width, height, patches });
        }
        Ok(())
    }

    fn colour(&self, index: u8) -> [u8; 3] {
        std::array::from_fn(|channel| self.palette[3 * usize::from(index) + channel])
    }

    /// The header and the columns of a patch.
    fn columns<'b>(&self, name: Name, lump: &'b [u8]) -> Result<Columns<'b>, Error> {
        let header = PatchHeader::ref_from_prefix(lump).ok().and_then(|(header, rest)| {
            let width = usize::from(header.width.get());
            let (columns, _) = <[U32]>::ref_from_prefix_with_elems(rest, width).ok()?;
            Some((header, columns))
        });
        header.ok_or_else(|| {
            let what = format!("{} bytes are too few for a patch", lump.len());
            self.wad.wrong_lump(name, what)
        })
    }

    /// Draws a patch into a picture with its upper left corner at `at`.
    fn draw(
        &self,
        name: Name,
        lump: &[u8],
        at: [i32; 2],
        picture: &mut Picture,
    ) -> Result<(), Error> {
        let wrong = |what| self.wad.wrong_lump(name, what);
        let (_, columns) = self.columns(name, lump)?;
        let height = picture.height();
        for (column, offset) in (0..).zip(columns) {
            let x = at[0] + column;
            let Ok(x) = usize::try_from(x) else { continue };
            if x >= picture.width {
                break;
            }
            let outside = || {
                let size = lump.len();
                wrong(format!("column {column} at byte {offset} is not within {size} bytes"))
            };
            let mut posts = lump.get(offset.get() as usize..).ok_or_else(outside)?;
            let mut top = -1_i32;
            loop {
                let (&from, rest) = posts.split_first().ok_or_else(outside)?;
                if from == u8::MAX {
                    break;
                }
                // Where posts do not go down, as in patches of over 254 rows, the number is the
                // distance from the last post.
                let from = i32::from(from);
                top = if from <= top { top + from } else { from };
                let (&count, rest) = rest.split_first().ok_or_else(outside)?;
                let count = usize::from(count);
                // A byte before and one after the texels are unused.
                let texels = rest.get(1..=count).ok_or_else(outside)?;
                posts = rest.get(count + 2..).ok_or_else(outside)?;
                for (row, &texel) in (0..).zip(texels) {
                    let y = usize::try_from(at[1] + top + row).unwrap_or(height);
                    if y < height {
                        picture.texels[y * picture.width + x] = Some(self.colour(texel));
                    }
                }
            }
        }
        Ok(())
    }
}

impl Pictures for Graphics<'_> {
    fn wall(&self, name: Name) -> Result<Option<Picture>, Error> {
        let Some(texture) = self.textures.get(&name) else {
            return Ok(None);
        };
        let texels = texture.width * texture.height;
        if texels.saturating_mul(texture.patches.len()) > MAX_TEXELS {
            let what = format!("{} patches of {texels} texels are too many", texture.patches.len());
            return Err(self.wad.wrong_lump(format!("TEXTURE1 {name}"), what));
        }
        let mut picture = Picture { width: texture.width, texels: vec![None; texels] };
        for record in texture.patches {
            let number = usize::from(record.patch.get());
            let Some(&patch) = self.patches.get(number) else {
                let count = self.patches.len();
                let what = format!("texture {name} has patch {number} of {count}");
                return Err(self.wad.wrong_lump("PNAMES", what));
            };
            let at = [record.x, record.y].map(|place| i32::from(place.get()));
            let patch = Name::of(patch);
            let lump = self.wad.lump_between(patch, ["P_START", "P_END"]);
            if let Some(lump) = lump.or_else(|| self.wad.lump(patch)) {
                self.draw(patch, lump, at, &mut picture)?;
            }
        }
        Ok(Some(picture))
    }

    fn flat(&self, name: Name) -> Result<Option<Picture>, Error> {
        let Some(lump) = self.wad.lump_between(name, ["F_START", "F_END"]) else {
            return Ok(None);
        };
        let Some(texels) = lump.get(..FLAT * FLAT) else {
            let what = format!("{} bytes are less than the {} of a flat", lump.len(), FLAT * FLAT);
            return Err(self.wad.wrong_lump(name, what));
        };
        let texels = texels.iter().map(|&texel| Some(self.colour(texel)));
        Ok(Some(Picture { width: FLAT, texels: texels.collect() }))
    }

    fn sprite(&self, name: Name) -> Result<Option<Sprite>, Error> {
        let Some(lump) = self.wad.lump_between(name, ["S_START", "S_END"]) else {
            return Ok(None);
        };
        let (header, _) = self.columns(name, lump)?;
        let [width, height] = [header.width, header.height].map(|side| usize::from(side.get()));
        if ![width, height].iter().all(|side| (1..=MAX_SIDE).contains(side)) {
            let what = format!("{width} by {height} texels; each must be from 1 to {MAX_SIDE}");
            return Err(self.wad.wrong_lump(name, what));
        }
        let mut picture = Picture { width, texels: vec![None; width * height] };
        self.draw(name, lump, [0, 0], &mut picture)?;
        Ok(Some(Sprite { picture, left: header.left.get(), top: header.top.get() }))
    }
}
