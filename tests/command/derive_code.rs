//! `derive --as`: code in the terminal and in a file; what can't be written is said.

use std::process::{Command, Output};

fn derive(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_polhode"));
    let command = command.arg("derive").args(arguments);
    command.output().expect("the command starts")
}

fn written(arguments: &[&str]) -> String {
    let output = derive(arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn the_known_inertia_is_that_of_the_body_or_of_numbers() {
    let text = written(&["--as", "c", "--of", "moment", "--body", "principal"]);
    assert!(text.contains("const double inertia[3]"), "{text}");
    let text = written(&["--as", "rust", "--of", "moment", "--inertia", "0.5,0.75,1"]);
    assert!(
        text.contains("0.5*a_x + 0.25*w_y*w_z") && !text.contains("inertia:"),
        "{text}"
    );
    let given = [
        "--as",
        "python",
        "--of",
        "moment",
        "--parameters",
        "urdf",
        "--inertia",
    ];
    let text = written(&[&given[..], &["2,0,-0.5,3,0,4"]].concat());
    assert!(
        text.contains("[2.0, 0.0, -0.5; 0.0, 3.0, 0.0; -0.5, 0.0, 4.0]"),
        "{text}"
    );
}

#[test]
fn columns_numbers_and_name_are_those_asked_for() {
    let columns = [
        "--wrt",
        "attitude,angular_velocity",
        "--precision",
        "f32",
        "--name",
        "linearised",
    ];
    let text = written(&[&["--as", "rust", "--of", "step-jacobian"][..], &columns].concat());
    assert!(
        text.contains("pub fn linearised(") && text.contains("[[f32; 6]; 6]"),
        "{text}"
    );
}

#[test]
fn what_cannot_be_written_is_said() {
    for (arguments, message) in [
        (&["--as", "c"][..], "--of"),
        (&["--of", "moment"], "--as"),
        (
            &["--as", "c", "--of", "moment", "--inertia", "1,2"],
            "three principal moments, or six",
        ),
        (
            &["--as", "c", "--of", "moment", "--inertia", "1,2,9"],
            "no body has",
        ),
        (
            &["--as", "c", "--of", "moment", "--wrt", "torque"],
            "no derivative in torque",
        ),
        (
            &["--as", "c", "--of", "moment", "--name", "while"],
            "can't be the name",
        ),
        (
            &["--as", "latex", "--of", "moment", "--format", "json"],
            "cannot be used with",
        ),
    ] {
        let output = derive(arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(message), "{arguments:?}: {said}");
    }
}
