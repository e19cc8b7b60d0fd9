//! Emitted code is compiled without a warning, run, and agrees with the library to rounding.
#![cfg(feature = "emit")]

use nalgebra::Matrix3;
use polhode::emit::{
    Column, EmitError, KnownInertia, Language, Precision, Quantity, Request, emit,
};
use polhode::mechanics::InertiaParameters;
use std::fs;
use std::path::Path;
use std::process::Command;

const QUANTITIES: [Quantity; 6] = [
    Quantity::Moment,
    Quantity::Acceleration,
    Quantity::Jacobian,
    Quantity::Regressor,
    Quantity::Step,
    Quantity::StepJacobian,
];

const ORDERS: [InertiaParameters; 4] = [
    InertiaParameters::MuJoCo,
    InertiaParameters::Lecture,
    InertiaParameters::Urdf,
    InertiaParameters::Pinocchio,
];

fn bodies() -> [KnownInertia; 7] {
    [
        KnownInertia::Full,
        KnownInertia::OnePlane,
        KnownInertia::Principal,
        KnownInertia::Axisymmetric,
        KnownInertia::Sphere,
        KnownInertia::Tensor(Matrix3::new(
            0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0,
        )),
        KnownInertia::Tensor(Matrix3::from_diagonal_element(0.4)),
    ]
}

/// A request for every quantity of every body, in all orders and with columns left out here and there.
fn requests(language: Language, precision: Precision) -> Vec<Request> {
    let mut requests = vec![];
    for of in QUANTITIES {
        for known in bodies() {
            let n = requests.len();
            let columns = match (of, n % 3) {
                (Quantity::Jacobian | Quantity::StepJacobian, 1) => vec![Column::AngularVelocity],
                (Quantity::StepJacobian, 2) => vec![Column::Dt, Column::Attitude],
                _ => vec![],
            };
            let request = Request {
                known,
                precision,
                columns,
                parameters: ORDERS[n % 4],
                name: Some(format!("code_{n}")),
                ..Request::new(of, language)
            };
            requests.push(request);
        }
    }
    let known = |request: &Request| matches!(request.known, KnownInertia::Tensor(_));
    requests.retain(|request| !(request.of == Quantity::Regressor && known(request)));
    requests
}

fn code(request: &Request) -> String {
    emit(request).expect("a request that can be met").text
}

/// What a command says; it must succeed.
fn said(command: &mut Command) -> String {
    let output = command.output().expect("the command can be started");
    let [out, error] =
        [output.stdout, output.stderr].map(|b| String::from_utf8_lossy(&b).into_owned());
    assert!(output.status.success(), "{command:?}:\n{out}{error}");
    out + &error
}

#[test]
fn rust_compiles_without_a_warning_and_agrees() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut modules = String::new();
    for precision in [Precision::Double, Precision::Single] {
        for request in requests(Language::Rust, precision) {
            let name = format!(
                "{precision:?}_{}",
                request.name.as_deref().unwrap_or_default()
            );
            let name = name.to_lowercase();
            fs::write(folder.path().join(format!("{name}.rs")), code(&request)).expect("written");
            modules += &format!("pub mod {name};\n");
        }
    }
    let [main, program] = ["main.rs", "program"].map(|name| folder.path().join(name));
    fs::write(&main, &modules).expect("written");
    let mut rustc = Command::new("rustc");
    rustc.args(["--edition=2024", "--test", "-Dwarnings"]);
    said(rustc.arg(&main).arg("-o").arg(&program));
    let count = modules.lines().count();
    assert!(said(&mut Command::new(program)).contains(&format!("{count} passed; 0 failed")));
}

/// Compiles and runs the test of a piece of C.
fn run_c(text: &str, folder: &Path) -> std::process::Output {
    let [source, program] = ["code.c", "program"].map(|name| folder.join(name));
    fs::write(&source, text).expect("written");
    let mut cc = Command::new("cc");
    cc.args([
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Werror",
        "-DPOLHODE_TEST",
    ]);
    said(cc.arg(&source).arg("-o").arg(&program).arg("-lm"));
    Command::new(&program).output().expect("a program")
}

#[test]
fn c_compiles_without_a_warning_and_agrees() {
    let folder = tempfile::tempdir().expect("a folder");
    for precision in [Precision::Double, Precision::Single] {
        for request in requests(Language::C, precision) {
            let done = run_c(&code(&request), folder.path());
            let said = String::from_utf8_lossy(&done.stdout);
            assert!(done.status.success(), "{request:?}: {said}");
        }
    }
}

#[test]
fn python_agrees() {
    if Command::new("python3").arg("--version").output().is_err() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let source = folder.path().join("code.py");
    let requests = requests(Language::Python, Precision::Double);
    let codes: Vec<_> = requests.iter().map(code).collect();
    fs::write(&source, codes.join("\n\n")).expect("written");
    said(Command::new("python3").arg("-Werror").arg(source));
}

/// The test that stands beside the code is one: it sees a changed sign.
#[test]
fn a_changed_sign_is_seen() {
    let folder = tempfile::tempdir().expect("a folder");
    for of in QUANTITIES {
        let text = code(&Request::new(of, Language::C));
        let (head, rest) = text.split_once("\n{\n").expect("a body");
        let changed = format!("{head}\n{{\n{}", rest.replacen(" - ", " + ", 1));
        let done = run_c(&changed, folder.path());
        assert!(!done.status.success(), "{of:?}");
    }
}

#[test]
fn latex_is_balanced_and_names_every_entry() {
    for request in requests(Language::Latex, Precision::Double) {
        let text = code(&request);
        let body: String = text.lines().filter(|line| !line.starts_with('%')).collect();
        let count = |piece: &str| body.matches(piece).count();
        assert_eq!(count("{"), count("}"), "{text}");
        assert_eq!(count("\\left("), count("\\right)"), "{text}");
        assert!(!body.contains('*') || count("*") == 2, "{text}");
    }
    let moment = code(&Request {
        known: KnownInertia::Principal,
        ..Request::new(Quantity::Moment, Language::Latex)
    });
    let line =
        r"M_{x} &= I_{xx} \dot\omega_{x} - \left(I_{yy} - I_{zz}\right) \omega_{y} \omega_{z} \\";
    assert!(moment.contains(line), "{moment}");
}

/// What is known is not computed: operations for a full tensor, one plane, principal axes, an axis of symmetry, a sphere, a
/// tensor of numbers, and a sphere of numbers.
#[test]
fn operations() {
    let table = [
        (Quantity::Moment, [42, 26, 15, 11, 3, 40, 3]),
        (Quantity::Acceleration, [81, 47, 18, 13, 4, 41, 3]),
        (Quantity::Jacobian, [246, 121, 42, 31, 10, 108, 3]),
        (Quantity::Step, [401, 319, 248, 228, 189, 358, 188]),
        (
            Quantity::StepJacobian,
            [3531, 2567, 1611, 1296, 864, 2252, 832],
        ),
    ];
    for (of, expected) in table {
        let counted = bodies().map(|known| {
            let request = Request {
                known,
                ..Request::new(of, Language::Rust)
            };
            let done = emit(&request).expect("code").operations;
            done.additions + done.multiplications + done.divisions + done.negations + done.roots
        });
        assert_eq!(counted, expected, "{of:?}");
    }
}

#[test]
fn what_cannot_be_written_is_an_error() {
    let refused = |change: fn(&mut Request)| {
        let mut request = Request::new(Quantity::Jacobian, Language::C);
        change(&mut request);
        emit(&request).expect_err("refused")
    };
    let plate_too_heavy = |r: &mut Request| {
        r.known = KnownInertia::Tensor(Matrix3::from_diagonal(&[1.0, 1.0, 2.1].into()));
    };
    assert!(matches!(refused(plate_too_heavy), EmitError::Inertia(_)));
    assert_eq!(
        refused(|r| r.columns = vec![Column::Torque, Column::Dt]),
        EmitError::NoColumn(Column::Dt)
    );
    let known = |r: &mut Request| r.known = KnownInertia::Tensor(Matrix3::identity());
    assert_eq!(
        refused(|r| {
            r.known = KnownInertia::Tensor(Matrix3::identity());
            r.columns = vec![Column::Inertia];
        }),
        EmitError::NoColumn(Column::Inertia)
    );
    let mut regressor = Request::new(Quantity::Regressor, Language::C);
    known(&mut regressor);
    assert_eq!(emit(&regressor), Err(EmitError::NoColumn(Column::Inertia)));
    for name in ["", "2d", "a-b", "while", "a b", "x;", "torque", "π"] {
        let request = Request {
            name: Some(name.into()),
            ..Request::new(Quantity::Moment, Language::Python)
        };
        assert_eq!(emit(&request), Err(EmitError::Name(name.into())));
    }
    let tiny = |r: &mut Request| {
        r.known = KnownInertia::Tensor(Matrix3::identity() * 1e-60);
        r.precision = Precision::Single;
    };
    assert_eq!(refused(tiny), EmitError::OutOfRange);
    let without_inverse = |r: &mut Request| {
        r.known = KnownInertia::Tensor(Matrix3::identity() * 1e-310);
    };
    assert_eq!(refused(without_inverse), EmitError::OutOfRange);
    let python = |r: &mut Request| {
        r.language = Language::Python;
        r.precision = Precision::Single;
    };
    assert_eq!(refused(python), EmitError::NoSingle);
}
