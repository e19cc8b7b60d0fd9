//! The inertia of a robot's link: which number is which, and what is said of files that are wrong.

use nalgebra::Matrix3;
use polhode::mechanics::Products;
use polhode::scene::{self, Scene};
use polhode::source::Source;
use std::{fs, path::Path};

const ROBOT: &str = r#"<?xml version="1.0"?>
<robot name="arm" xmlns:xacro="http://ros.org/wiki/xacro">
  <link name="base"/>
  <link name="upper">
    <visual><geometry><box size="1 1 1"/></geometry></visual>
    <inertial>
      <origin xyz="0.3 0 -0.4" rpy="0 0 0"/>
      <mass value="2"/>
      <inertia ixx="0.5" ixy="-0.01" ixz="0.02" iyy="0.6" iyz="0.03" izz="0.7"/>
    </inertial>
  </link>
  <link name="turned">
    <inertial>
      <origin rpy="0 0 0.7853981633974483"/>
      <mass value="1.5"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5"/>
    </inertial>
  </link>
  <link name="thrice">
    <inertial>
      <origin rpy="1.5707963267948966 1.5707963267948966 0"/>
      <mass value="1"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5"/>
    </inertial>
  </link>
  <link name="formula">
    <inertial><mass value="${m}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  </link>
  <link name="flat">
    <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"/></inertial>
  </link>
  <link name="light">
    <inertial><mass value="0"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  </link>
</robot>
"#;

fn read(folder: &Path, keys: &str) -> Result<Scene, String> {
    let text = format!(
        "[[body]]\nname = 'a'\n{keys}\nangular_velocity = [1, 0, 0]\n[run]\nduration = 1\n"
    );
    let name = folder.join("scene.toml").to_string_lossy().into_owned();
    scene::read(&Source::new(name, text)).map_err(|errors| {
        let said: Vec<_> = errors
            .iter()
            .map(|e| format!("{} {:?}", e.message, e.helps))
            .collect();
        said.join("\n")
    })
}

fn tensor(keys: &str) -> Matrix3<f64> {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("arm.urdf"), ROBOT).expect("written");
    let scene = read(folder.path(), &format!("urdf = 'arm.urdf'\n{keys}")).expect("a good scene");
    let shared = scene.groups[0].shared_body().expect("a body");
    *shared.expect("one for all").inertia()
}

#[test]
fn products_are_entries_of_the_tensor() {
    let found = tensor("link = 'upper'");
    let expected = Matrix3::new(0.5, -0.01, 0.02, -0.01, 0.6, 0.03, 0.02, 0.03, 0.7);
    assert_eq!(found, expected);
}

#[test]
fn about_the_joint_the_mass_has_its_lever() {
    let found = tensor("link = 'upper'\nabout = 'origin'") - tensor("link = 'upper'");
    // m (|r|² 1 − r rᵀ) with m = 2, r = (0.3, 0, −0.4), worked out by hand.
    let lever = Matrix3::new(0.32, 0.0, 0.24, 0.0, 0.5, 0.0, 0.24, 0.0, 0.18);
    assert!((found - lever).amax() < 1e-15, "{found}");
}

#[test]
fn the_axes_of_the_tensor_are_turned_to_those_of_the_link() {
    // By 45° about z: the mean of 1 and 2 on the diagonal, half their difference beside it, less than 0 since the
    // smaller moment lies along (1, 1, 0).
    let found = tensor("link = 'turned'");
    let expected = Matrix3::new(1.5, -0.5, 0.0, -0.5, 1.5, 0.0, 0.0, 0.0, 2.5);
    assert!((found - expected).amax() < 1e-15, "{found}");
    // First 90° about x (y to z, z to −y), then 90° about the fixed y (z to x, x to −z): y ends along x, z along −y,
    // x along −z. In the other order z would end along x.
    let found = tensor("link = 'thrice'");
    let expected = Matrix3::from_diagonal(&nalgebra::Vector3::new(2.0, 2.5, 1.0));
    assert!((found - expected).amax() < 1e-15, "{found}");
}

#[test]
fn the_jacobian_has_the_convention_of_the_file_unless_another_is_said() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("arm.urdf"), ROBOT).expect("written");
    let products = |keys: &str| {
        let scene = read(
            folder.path(),
            &format!("urdf = 'arm.urdf'\nlink = 'upper'\n{keys}"),
        );
        scene.expect("a good scene").groups[0].products
    };
    assert_eq!(products(""), Products::Entries);
    assert_eq!(products("products = 'integrals'"), Products::Integrals);
}

#[test]
fn a_bad_description_is_told_what_and_where() {
    let folder = tempfile::tempdir().expect("a folder");
    let write =
        |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("written");
    write("arm.urdf", ROBOT);
    write("empty.urdf", "");
    write("page.urdf", "<html><link name='a'/></html>");
    write("cut.urdf", &ROBOT[..300]);
    let (open, close) = ("<a>".repeat(200_000), "</a>".repeat(200_000));
    write("deep.urdf", &format!("<robot>{open}{close}</robot>"));
    let laughs = (1..12).fold("<!ENTITY l0 'ha'>".to_owned(), |text, n| {
        format!(
            "{text}<!ENTITY l{n} '{}'>",
            format!("&l{};", n - 1).repeat(10)
        )
    });
    write(
        "laughs.urdf",
        &format!("<!DOCTYPE robot [{laughs}]><robot>&l11;</robot>"),
    );
    fs::create_dir(folder.path().join("folder.urdf")).expect("made");
    for (keys, said) in [
        ("urdf = 'arm.urdf'", "needs the key `link`"),
        (
            "urdf = 'arm.urdf'\nlink = 'lower'",
            "no such link; there are base, upper",
        ),
        (
            "urdf = 'arm.urdf'\nlink = 'base'",
            "arm.urdf:3:3: the <link> has no <inertial>",
        ),
        (
            "urdf = 'arm.urdf'\nlink = 'formula'",
            "expand the file to URDF first",
        ),
        ("urdf = 'arm.urdf'\nlink = 'flat'", "the largest exceeds"),
        ("urdf = 'arm.urdf'\nlink = 'light'", "the mass is 0"),
        (
            "urdf = 'arm.urdf'\nlink = 'upper'\nabout = 'orign'",
            "write `origin`",
        ),
        ("urdf = 'none.urdf'\nlink = 'a'", "none.urdf: No such file"),
        ("urdf = 'folder.urdf'\nlink = 'a'", "is no regular file"),
        ("urdf = '/dev/zero'\nlink = 'a'", "is no regular file"),
        ("urdf = 'empty.urdf'\nlink = 'a'", "empty.urdf: "),
        ("urdf = 'page.urdf'\nlink = 'a'", "begins with <robot>"),
        ("urdf = 'cut.urdf'\nlink = 'upper'", "cut.urdf: "),
        (
            "urdf = 'deep.urdf'\nlink = 'a'",
            "no such link; there are none",
        ),
        ("urdf = 'laughs.urdf'\nlink = 'a'", "laughs.urdf: "),
        ("urdf = 5\nlink = 'a'", "has to be a text"),
        ("link = 'a'", "belongs to `urdf`"),
        (
            "urdf = 'arm.urdf'\nlink = 'upper'\ninertia = { xx = 1, yy = 1, zz = 1 }",
            "an inertia of its own",
        ),
    ] {
        let found = read(folder.path(), keys).expect_err("a bad scene");
        assert!(found.contains(said), "{keys}: {found}");
    }
}
