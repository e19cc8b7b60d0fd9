//! `urdf`: the inertia of a robot's link.
//!
//! Read with a plain XML tree: a robot description is small, and what stands beside the `<inertial>` of the link is
//! none of a scene's business. Its products of inertia are entries of the tensor (the URDF specification, `inertial`).

use crate::diagnostic::Diagnostic;
use crate::mechanics::{Products, inertia, parallel_axis};
use crate::scene::InertiaForm;
use crate::scene::read::reader::{Reader, Table, Value, span};
use nalgebra::{Matrix3, Vector3};
use roxmltree::{Document, Node, ParsingOptions};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// The largest robot description that is read, in bytes, and its most elements.
const LIMIT: u64 = 16 << 20;
const MOST_NODES: u32 = 1 << 20;

/// The inertia of the link that the keys `urdf`, `link` and `about` of a body name, along the axes of the link.
pub(super) fn link(
    reader: &mut Reader,
    table: &Table<'_>,
    file: &Value<'_>,
) -> Option<InertiaForm> {
    let about_origin = match table.get("about") {
        Some(value) => reader.word(value, "point of reference", super::inertia::POINTS)?,
        None => false,
    };
    let path = reader
        .text(file, "the path of a robot description")?
        .to_owned();
    let link = reader.required(table, "link")?;
    let name = reader.text(link, "the name of a link")?.to_owned();
    let text = match read(&reader.folder.join(&path)) {
        Ok(text) => text,
        Err(error) => return reader.wrong(file, format!("{path}: {error}")),
    };
    match tensor(&text, &name, about_origin) {
        Ok(tensor) => Some(InertiaForm::Link(tensor)),
        Err(Wrong::Link(message)) => {
            let unknown = Diagnostic::error("bad-value", span(link.span()), message);
            reader.report(unknown);
            None
        }
        Err(Wrong::File(message)) => reader.wrong(file, format!("{path}{message}")),
    }
}

/// The text of a regular file of moderate size.
fn read(path: &Path) -> io::Result<String> {
    // Looked at before it is opened: to open a pipe would wait for its writer.
    let kind = fs::metadata(path)?;
    if !kind.is_file() {
        return Err(io::Error::other("is no regular file"));
    }
    let mut text = String::new();
    File::open(path)?
        .take(LIMIT + 1)
        .read_to_string(&mut text)?;
    if text.len() as u64 > LIMIT {
        return Err(io::Error::other("is too large for a robot description"));
    }
    Ok(text)
}

/// What is wrong: that there is no such link, or something in the file, `:line:column: …`.
enum Wrong {
    Link(String),
    File(String),
}

fn at(node: &Node<'_, '_>, message: impl std::fmt::Display) -> Wrong {
    let place = node.document().text_pos_at(node.range().start);
    Wrong::File(format!(":{}:{}: {message}", place.row, place.col))
}

fn tensor(text: &str, name: &str, about_origin: bool) -> Result<Matrix3<f64>, Wrong> {
    let options = ParsingOptions {
        nodes_limit: MOST_NODES,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(text, options)
        .map_err(|error| Wrong::File(format!(": {error}")))?;
    let robot = document.root_element();
    if !robot.has_tag_name("robot") {
        return Err(at(&robot, "a robot description begins with <robot>"));
    }
    let is_link = |node: &Node<'_, '_>| node.has_tag_name("link");
    let mut links = robot.children().filter(is_link);
    let named = |node: &Node<'_, '_>| node.attribute("name") == Some(name);
    let Some(link) = links.find(named) else {
        return Err(Wrong::Link(format!(
            "there is no such link; there are {}",
            names(&robot)
        )));
    };
    let inertial = child(&link, "inertial")?;
    let mass = number(&child(&inertial, "mass")?, "value")?;
    if !(mass > 0.0 && mass.is_finite()) {
        return Err(at(
            &inertial,
            format!("the mass is {mass}, and has to be positive and finite"),
        ));
    }
    let found = child(&inertial, "inertia")?;
    let of = |keys: [&'static str; 3]| -> Result<[f64; 3], Wrong> {
        let [a, b, c] = keys.map(|key| number(&found, key));
        Ok([a?, b?, c?])
    };
    let moments = of(["ixx", "iyy", "izz"])?;
    let products = of(["ixy", "ixz", "iyz"])?;
    let about_centre = inertia(moments, products, Products::Entries);
    let origin = inertial.children().find(|n| n.has_tag_name("origin"));
    let [centre, turn] = match origin {
        Some(origin) => [vector(&origin, "xyz")?, vector(&origin, "rpy")?],
        None => [Vector3::zeros(); 2],
    };
    let along_link = turned(&about_centre, &turn);
    Ok(if about_origin {
        parallel_axis(&along_link, &mass, &centre)
    } else {
        along_link
    })
}

/// The first links, as a message names them.
fn names(robot: &Node<'_, '_>) -> String {
    const SHOWN: usize = 8;
    let links = || robot.children().filter(|n| n.has_tag_name("link"));
    let shown: Vec<String> = links()
        .filter_map(|link| link.attribute("name"))
        .take(SHOWN)
        .map(|name| name.chars().take(40).collect())
        .collect();
    match links().count() {
        0 => "none".to_owned(),
        n if n > SHOWN => format!("{} and {} more", shown.join(", "), n - SHOWN),
        _ => shown.join(", "),
    }
}

fn child<'a, 'b>(node: &Node<'a, 'b>, name: &str) -> Result<Node<'a, 'b>, Wrong> {
    let mut children = node.children().filter(|n| n.has_tag_name(name));
    match (children.next(), children.next()) {
        (Some(child), None) => Ok(child),
        (None, _) => {
            let tag = node.tag_name().name();
            Err(at(node, format!("the <{tag}> has no <{name}>")))
        }
        (_, Some(second)) => Err(at(&second, format!("there is a second <{name}>"))),
    }
}

fn number(node: &Node<'_, '_>, key: &str) -> Result<f64, Wrong> {
    let tag = node.tag_name().name();
    let Some(text) = node.attribute(key) else {
        return Err(at(node, format!("the <{tag}> has no {key}")));
    };
    parsed(node, key, text)
}

fn parsed(node: &Node<'_, '_>, key: &str, text: &str) -> Result<f64, Wrong> {
    if text.contains("${") {
        let message = format!("{key} is a formula of xacro; expand the file to URDF first");
        return Err(at(node, message));
    }
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(at(node, format!("{key} is no finite number"))),
    }
}

/// Three numbers, 0 where nothing is said.
fn vector(node: &Node<'_, '_>, key: &str) -> Result<Vector3<f64>, Wrong> {
    let Some(text) = node.attribute(key) else {
        return Ok(Vector3::zeros());
    };
    let numbers: Vec<f64> = text
        .split_whitespace()
        .take(4)
        .map(|text| parsed(node, key, text))
        .collect::<Result<_, _>>()?;
    match numbers[..] {
        [x, y, z] => Ok(Vector3::new(x, y, z)),
        _ => Err(at(node, format!("{key} has to be three numbers"))),
    }
}

/// A tensor given along axes that are turned against the link's by roll, pitch, yaw about its fixed axes x, y, z.
fn turned(tensor: &Matrix3<f64>, angles: &Vector3<f64>) -> Matrix3<f64> {
    if *angles == Vector3::zeros() {
        return *tensor;
    }
    let [(sr, cr), (sp, cp), (sy, cy)] = [angles.x, angles.y, angles.z].map(f64::sin_cos);
    let roll = Matrix3::new(1.0, 0.0, 0.0, 0.0, cr, -sr, 0.0, sr, cr);
    let pitch = Matrix3::new(cp, 0.0, sp, 0.0, 1.0, 0.0, -sp, 0.0, cp);
    let yaw = Matrix3::new(cy, -sy, 0.0, sy, cy, 0.0, 0.0, 0.0, 1.0);
    let axes = yaw * pitch * roll;
    let full = axes * tensor * axes.transpose();
    // Both halves the same, to the last bit.
    Matrix3::from_fn(|r, c| full[(r.min(c), r.max(c))])
}
