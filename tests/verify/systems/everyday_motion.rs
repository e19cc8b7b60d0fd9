//! Plane motion in everyday sentences: rods that fall, strings that unwind, what rolls in a hollow, lifts, bearings.

use super::{judged, verdicts};

const FALLING: &str = r"
K is an inertial frame, and $\mathbf{k}$ is the upward vertical.
The rod is thin and uniform and has the mass $m$ and the length $c$.
The rod is hinged at its end Q, which is fixed in K, and turns about a horizontal axis.
$\alpha$ is the angle between the rod and the upward vertical.
The rod starts from rest at $\alpha=0$.
The weight and the force of the hinge are the only loads on the rod.
$T$ is the kinetic energy of the rod.
$u$ is the unit vector from Q along the rod, and $v$ is the unit vector at right angles to it in the direction of increasing $\alpha$.
$F$ is the component of the force of the hinge on the rod along $u$.
$g$ is the acceleration of gravity.
";

#[test]
fn the_name_of_the_vertical_leaves_the_plane_of_a_rod_open() {
    let text = r"
$$ T=\tfrac16mc^2\dot\alpha^2 $$
$$ \dot\alpha^2=\frac{3g}{c}(1-\cos\alpha) $$
$$ F=\tfrac12mg(5\cos\alpha-3) $$
";
    assert_eq!(judged(FALLING, text), "ppp");
    let text = r"
$$ \dot\alpha^2=\frac{3g}{c}(1+\cos\alpha) $$
$$ F=\tfrac12mg(5\cos\alpha+3) $$
";
    assert!(!judged(FALLING, text).contains('p'));
}

#[test]
fn where_a_level_axis_has_a_name_the_plane_is_not_chosen() {
    let named = FALLING.replace(
        r"K is an inertial frame, and $\mathbf{k}$ is the upward vertical.",
        "K is an inertial frame with the axes x, y, z, and z is the upward vertical.",
    );
    let sentences =
        format!("{named}$w$ is the angular velocity of the rod relative to K along y.\n");
    assert_eq!(verdicts(&sentences, r"$$ w=\dot\alpha $$").0, "u");
}

const UNWINDING: &str = r"
Z is the downward vertical and is an axis of the inertial frame K.
The wheel is a rigid body of mass $m$ that is symmetric about its horizontal axis through C.
C is the mass centre of the wheel.
The cord hangs from Q, and Q is a point fixed in K.
The cord unwinds without slipping from the axle, whose radius is $b$.
The cord stays vertical.
$p$ is the angle through which the wheel has turned as the cord unwinds.
$v$ is the component of the velocity of C relative to K along Z.
$I$ is the moment of inertia of the wheel about its axis through C.
$F$ is the tension of the cord.
The weight and the pull of the cord are the only loads on the wheel.
$g$ is the acceleration of gravity.
";

const UNWINDS: &str = r"
$$ v=b\dot p $$
$$ m\dot v=mg-F $$
$$ I\ddot p=bF $$
$$ \dot v=\frac{mgb^2}{I+mb^2} $$
$$ v=-b\dot p $$
$$ m\dot v=mg+F $$
$$ I\ddot p=-bF $$
$$ F=mg $$
";

#[test]
fn a_body_rolls_down_the_string_that_unwinds_from_it() {
    assert_eq!(judged(UNWINDING, UNWINDS), "pppprrrr");
}

#[test]
fn what_unwinds_goes_down_whichever_way_the_axis_points() {
    let up = UNWINDING.replace("downward vertical", "upward vertical");
    let text = r"
$$ v=-b\dot p $$
$$ m\dot v=F-mg $$
$$ I\ddot p=bF $$
$$ v=b\dot p $$
";
    assert_eq!(judged(&up, text), "pppr");
}

#[test]
fn a_string_that_need_not_be_vertical_is_no_plane() {
    for without in ["The cord stays vertical.\n", "The cord hangs from Q, and "] {
        let sentences = UNWINDING.replace(without, "");
        let found = verdicts(&sentences, UNWINDS).0;
        assert!(!found.contains(['p', 'r']), "{without}: {found}");
    }
}

const HOLLOW: &str = r"
K is an inertial frame; x, y, z are its axes and y is the upward vertical.
The pipe is a hollow circular cylinder fixed in K, of radius $b$, whose axis passes through the point Q along z.
Inside the pipe a homogeneous solid cylinder of mass $m$ and radius $a$ rolls without slipping, with its axis parallel to z.
C is the centre of the cylinder.
$q$ is the angle from the downward vertical to the line from Q to C, positive about z.
$w$ is the angular velocity of the cylinder relative to K along z.
$T$ is the kinetic energy of the cylinder.
";

#[test]
fn the_centre_of_what_rolls_in_a_hollow_is_as_far_off_as_the_radii_differ() {
    let text = r"
$$ aw=-(b-a)\dot q $$
$$ T=\tfrac34m(b-a)^2\dot q^2 $$
$$ aw=(b-a)\dot q $$
$$ T=\tfrac34m(b+a)^2\dot q^2 $$
";
    assert_eq!(judged(HOLLOW, text), "pprr");
}

#[test]
fn a_frame_moves_along_an_axis_without_turning() {
    let sentences = r"
K is an inertial frame with the axes x, y, z, where y points up.
The cage is a frame that moves along $y$ with the speed $u$ relative to K, without turning.
Q is a point fixed in the cage.
P is a particle of mass $m$.
P is placed from Q by $s\,x$.
$v$ is the velocity of P relative to K.
";
    let sentences = sentences.replace("axes x, y, z, where y points up", "axes $x$, $y$, $z$");
    let text = r"
$$ v=\dot s\,x+u\,y $$
$$ v=\dot s\,x $$
";
    assert_eq!(judged(&sentences, text), "pr");
}

#[test]
fn an_acceleration_is_no_speed() {
    let sentences = r"
K is an inertial frame with the axes $x$, $y$, $z$.
P is a particle of mass $m$.
P moves relative to K along $x$ with the constant acceleration $a$.
$v$ is the velocity of P relative to K.
$F$ is the total force on P.
";
    let text = r"
$$ F=m a\,x $$
$$ v=a\,x $$
";
    let found = judged(sentences, text);
    assert!(found.starts_with('p') && !found.ends_with('p'), "{found}");
}

const SHAFT: &str = r"
K is an inertial frame and R is a frame fixed in the rotor.
The axes of R are $i$, $j$, $k$.
The rotor is a rigid body of mass $m$ that turns relative to K about $k$ at the constant rate $w$.
P and Q are points; P is fixed in K and in R, and Q is at the distance $c$ from P along $k$.
The mass centre of the rotor is placed from P by $e\,i+h\,k$.
The force of the bearing P on the rotor has the components $a$ and $b$ along $i$ and $j$, and that of the bearing Q has the components $p$ and $q$.
No other loads act on the rotor; its weight is neglected.
";

#[test]
fn no_other_loads_are_those_that_are_told() {
    let text = r"
$$ a+p=-mew^2 $$
$$ b+q=0 $$
$$ a+p=mew^2 $$
$$ a=-mew^2 $$
";
    assert_eq!(&judged(SHAFT, text)[..3], "ppr");
    assert_ne!(&judged(SHAFT, text)[3..], "p");
}

#[test]
fn a_slope_acts_with_friction_up_and_a_normal_force() {
    let sentences = r"
K is an inertial frame.
The ramp is a plane fixed in K that makes the angle $\beta$ with the horizontal.
W is a uniform solid cylinder of mass $m$ and radius $b$ with its axis horizontal.
W rolls straight down the ramp without slipping.
P is the point where W touches the ramp, and C is the mass centre of W.
$v$ is the speed of C down the ramp, and $w$ is the angular velocity of W.
$F$ is the friction of the ramp on W at P, and $N$ is the normal force of the ramp on W at P.
Apart from the weight no other load acts on W.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ v=bw $$
$$ F=\tfrac13mg\sin\beta $$
$$ N=mg\cos\beta $$
$$ v=-bw $$
$$ F=\tfrac23mg\sin\beta $$
$$ N=mg\sin\beta $$
";
    assert_eq!(judged(sentences, text), "ppprrr");
}

#[test]
fn a_cone_lies_from_its_apex_along_an_axis() {
    let sentences = r"
The cone is a uniform solid circular cone with the mass $m$, the height $h$ and the base radius $b$.
K is a frame fixed in the cone; its axes are x, y, z.
Q is the apex of the cone, and z runs from Q along the axis of the cone to the middle of its base.
C is the mass centre of the cone; it lies at the distance $s$ from Q along z.
$J$ is the moment of inertia of the cone about the axis through Q along x.
";
    let text = r"
$$ s=\tfrac34h $$
$$ J=\tfrac3{20}m(b^2+4h^2) $$
$$ s=-\tfrac34h $$
$$ J=\tfrac3{20}m(b^2+h^2) $$
";
    let found = verdicts(sentences, text).0;
    assert!(
        found.starts_with("pp") && !found[2..].contains('p'),
        "{found}"
    );
}

#[test]
fn a_plate_turns_about_its_diagonal() {
    let sentences = r"
K is an inertial frame.
E is a frame fixed in the plate, whose axes are $i$, $j$, $k$.
The plate is a uniform thin rectangle of mass $m$ with its centre at C and with sides $2a$ along $i$ and $2b$ along $j$.
C is at rest in K.
The plate turns relative to K about the axis through C along $ai+bj$ at the constant rate $w$.
$\vec\omega$ is the angular velocity of the plate relative to K.
$\vec L$ is the angular momentum of the plate about C relative to K.
";
    let text = r"
$$ \vec\omega=\frac{w(ai+bj)}{\sqrt{a^2+b^2}} $$
$$ \vec L=\frac{mabw}{3\sqrt{a^2+b^2}}(bi+aj) $$
$$ \vec\omega=\frac{w(bi+aj)}{\sqrt{a^2+b^2}} $$
$$ \vec L=\frac{mabw}{3\sqrt{a^2+b^2}}(ai+bj) $$
";
    assert_eq!(judged(sentences, text), "pprr");
}

const PULLEY: &str = r"
The room is an inertial frame.
The pulley is a uniform disc whose mass is $M$ and whose radius is $b$.
It turns without friction about its horizontal axis, which is fixed in the room.
$I$ is the moment of inertia of the pulley about that axis.
A massless string that does not stretch runs over the pulley without slipping and carries the particles P and Q at its ends.
P has the mass $m$, and Q has the mass $n$.
$a$ is the acceleration of P downward relative to the room.
The tensions of the string at P and at Q are $F$ and $H$, respectively.
$g$ is the acceleration of gravity.
";

#[test]
fn what_hangs_over_a_pulley_goes_down_on_one_side_and_up_on_the_other() {
    let text = r"
$$ I=\tfrac12Mb^2 $$
$$ mg-F=ma $$
$$ H-ng=na $$
$$ (F-H)b=\tfrac12Mba $$
$$ a=\frac{2(m-n)g}{2m+2n+M} $$
$$ H-ng=-na $$
$$ F=H $$
$$ (H-F)b=\tfrac12Mba $$
$$ a=\frac{(m-n)g}{m+n} $$
";
    assert_eq!(judged(PULLEY, text), "ppppprrrr");
}

#[test]
fn a_pulley_that_may_be_held_back_by_friction_is_left_open() {
    let sentences = PULLEY.replace("It turns without friction about", "It turns about");
    let text = r"
$$ (F-H)b=\tfrac12Mba $$
$$ (H-F)b=\tfrac12Mba $$
";
    assert_eq!(verdicts(&sentences, text).0, "uu");
}

#[test]
fn a_load_falls_as_its_string_unwinds_from_a_drum() {
    let sentences = r"
The room is an inertial frame.
The drum is a uniform disc of mass $M$ and radius $b$.
The drum turns without friction about its horizontal axis, which is fixed in the room.
A massless string is wound round the drum.
P is a particle of mass $m$.
P hangs from the string.
$a$ is the downward acceleration of P relative to the room.
$F$ is the tension of the string.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ ma=mg-F $$
$$ F=\tfrac12Ma $$
$$ a=\frac{2mg}{2m+M} $$
$$ F=mg $$
$$ a=g $$
";
    assert_eq!(judged(sentences, text), "ppprr");
}

#[test]
fn a_letter_beside_its_rate_is_no_axis_at_rest() {
    let sentences = r"
z points vertically downward and is an axis of the inertial frame K.
P is a particle of mass $m$.
$m$ is constant.
$g$ is the acceleration of gravity.
";
    let text = r"
$$ \tfrac12m\dot z^2+mgz=\text{const} $$
";
    assert_eq!(verdicts(sentences, text).0, "u");
}
