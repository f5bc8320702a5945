//! Files of other programs: names their formats, so that a message names the kind of a file.

use std::path::Path;

/// How files of a format begin.
const BEGINNINGS: [(&[u8], &str); 21] = [
    (b"Kaydara FBX Binary", "an FBX file"),
    (b"; FBX", "an FBX file"),
    (b"BLENDER", "a Blender (.blend) file"),
    (b"#usda", "a USD file"),
    (b"PXR-USDC", "a USD file"),
    (b"#VRML", "a VRML file"),
    (b"#X3D", "an X3D file"),
    (b"ISO-10303-21", "a STEP file"),
    (b"OFF\n", "an OFF file"),
    (b"COFF\n", "an OFF file"),
    (b"xof ", "a DirectX (.x) file"),
    (b"3D Geometry File Format", "a Rhino (.3dm) file"),
    (b"#INVENTOR", "an Open Inventor file"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"PK\x03\x04", "a ZIP archive"),
    (b"\x1f\x8b", "a gzip archive"),
    (b"\x7fELF", "a program"),
    (b"newmtl", "a material library of OBJ files"),
    (b"{", "a JSON file that is not glTF"),
    (b"nff\n", "a Sense8 (WorldToolKit) NFF file, not one of Eric Haines' Neutral File Format"),
    (b"nff\r", "a Sense8 (WorldToolKit) NFF file, not one of Eric Haines' Neutral File Format"),
];

/// The file name extensions of formats whose beginnings are less distinct.
const ENDINGS: [(&str, &str); 32] = [
    ("3dm", "a Rhino (.3dm) file"),
    ("3ds", "a 3D Studio (.3ds) file"),
    ("3mf", "a 3MF file"),
    ("abc", "an Alembic file"),
    ("blend", "a Blender (.blend) file"),
    ("c4d", "a Cinema 4D file"),
    ("dae", "a COLLADA (.dae) file"),
    ("dwg", "an AutoCAD file"),
    ("dxf", "an AutoCAD file"),
    ("fbx", "an FBX file"),
    ("iges", "an IGES file"),
    ("igs", "an IGES file"),
    ("lwo", "a LightWave file"),
    ("ma", "a Maya file"),
    ("max", "a 3ds Max file"),
    ("mb", "a Maya file"),
    ("mtl", "a material library of OBJ files"),
    ("off", "an OFF file"),
    ("pbrt", "a pbrt scene"),
    ("pov", "a POV-Ray scene"),
    ("rib", "a RenderMan (.rib) scene"),
    ("skp", "a SketchUp file"),
    ("step", "a STEP file"),
    ("stp", "a STEP file"),
    ("usd", "a USD file"),
    ("usda", "a USD file"),
    ("usdc", "a USD file"),
    ("usdz", "a USD file"),
    ("wrl", "a VRML file"),
    ("x", "a DirectX (.x) file"),
    ("x3d", "an X3D file"),
    ("xml", "an XML file"),
];

/// The format of a file by how it begins.
pub(crate) fn of_bytes(beginning: &[u8]) -> Option<&'static str> {
    let text = beginning.strip_prefix(b"\xef\xbb\xbf").unwrap_or(beginning);
    let text = text.trim_ascii_start();
    let mut known = BEGINNINGS.iter();
    if let Some((_, name)) = known.find(|(start, _)| text.starts_with(start)) {
        return Some(name);
    }
    let has = |word: &[u8]| text.windows(word.len()).any(|part| part == word);
    if !text.starts_with(b"<") {
        None
    } else if has(b"<COLLADA") {
        Some("a COLLADA (.dae) file")
    } else if has(b"<X3D") {
        Some("an X3D file")
    } else {
        Some("an XML file")
    }
}

/// The format of a file by the end of its name, or that it is no text, which has no bytes of 0.
pub(crate) fn of_name(name: &Path, beginning: &[u8]) -> Option<&'static str> {
    let ending = name.extension().and_then(|it| it.to_str());
    let ending = ending.map(str::to_ascii_lowercase);
    let found = ENDINGS.iter().find(|(known, _)| Some(*known) == ending.as_deref());
    let binary = beginning.contains(&0);
    found.map(|&(_, name)| name).or(binary.then_some("a binary file of an unknown format"))
}
