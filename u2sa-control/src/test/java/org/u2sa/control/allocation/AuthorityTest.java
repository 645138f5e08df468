package org.u2sa.control.allocation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.Point;

class AuthorityTest {
  private static final Set<DegreeOfFreedom> CONTROLLED =
      EnumSet.complementOf(EnumSet.of(DegreeOfFreedom.PITCH));
  private static final Authority SOUND = Authority.of(SixThrusters.effectors(), CONTROLLED);

  private static Authority without(String... names) {
    List<Effector> left = new ArrayList<>(SixThrusters.effectors());
    left.removeIf(each -> List.of(names).contains(each.name()));
    return Authority.of(left, CONTROLLED);
  }

  @Test
  void most_allSixThrusters_isBoundByTheWeakerDirection() {
    // Pure yaw runs two thrusters astern: 30 N each, and the other two no harder.
    double arm = (0.16 + 0.11) * Math.sqrt(0.5);
    assertThat(SOUND.most(DegreeOfFreedom.YAW)).isCloseTo(4 * 30.0 * arm, within(0.05));
    assertThat(SOUND.most(DegreeOfFreedom.SURGE)).isCloseTo(4 * 30.0 * Math.sqrt(0.5), within(0.1));
    assertThat(SOUND.most(DegreeOfFreedom.HEAVE)).isCloseTo(2 * 30.0, within(0.1));
    assertThat(SOUND.words(SOUND)).isEmpty();
  }

  @Test
  void words_oneHorizontalThrusterLost_sayHalfOfThePlane() {
    assertThat(without("T1").words(SOUND))
        .isEqualTo("authority left: surge 50 %, sway 50 %, yaw 50 %");
  }

  @Test
  void words_oneVerticalThrusterLost_sayThatHeaveAndRollCannotBeApart() {
    assertThat(without("T5").words(SOUND)).isEqualTo("cannot control heave, roll");
  }

  @Test
  void words_allLost_nameEveryAxis() {
    assertThat(without("T1", "T2", "T3", "T4", "T5", "T6").words(SOUND))
        .isEqualTo("cannot control surge, sway, heave, roll, yaw");
  }

  /** Rotors that only lift, in a square; and thrusters of a boat that only push ahead. */
  @Test
  void words_actuatorsOfOneDirection_areEmptyWhileAllAreSound() {
    Set<DegreeOfFreedom> copter =
        EnumSet.of(
            DegreeOfFreedom.HEAVE,
            DegreeOfFreedom.ROLL,
            DegreeOfFreedom.PITCH,
            DegreeOfFreedom.YAW);
    List<Effector> rotors = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      double x = i < 2 ? 0.2 : -0.2;
      double y = i % 2 == 0 ? 0.2 : -0.2;
      double spin = x * y > 0.0 ? 0.1 : -0.1;
      rotors.add(oneWay("R" + i, Point.of(0.0, 0.0, -10.0), Point.of(-10.0 * y, 10.0 * x, spin)));
    }
    Authority lifts = Authority.of(rotors, copter);
    assertThat(lifts.words(lifts)).isEmpty();
    assertThat(Authority.of(rotors.subList(1, 4), copter).lost(lifts))
        .contains(DegreeOfFreedom.HEAVE);

    Set<DegreeOfFreedom> boat = EnumSet.of(DegreeOfFreedom.SURGE, DegreeOfFreedom.YAW);
    List<Effector> ahead =
        List.of(
            oneWay("PORT", Point.of(50.0, 0.0, 0.0), Point.of(0.0, 0.0, 15.0)),
            oneWay("STARBOARD", Point.of(50.0, 0.0, 0.0), Point.of(0.0, 0.0, -15.0)));
    Authority drives = Authority.of(ahead, boat);
    assertThat(drives.words(drives)).isEmpty();
    assertThat(Authority.of(ahead.subList(0, 1), boat).lost(drives)).contains(DegreeOfFreedom.YAW);
  }

  private static Effector oneWay(String name, Point force, Point moment) {
    return Effector.ofSound(
            new ActuatorAnnouncement()
                .actuatorName(name)
                .minimum(0.0)
                .maximum(100.0)
                .force(force)
                .moment(moment))
        .orElseThrow();
  }

  @Test
  void roster_silentThriceItsRenewal_isLostAndBackWithItsNextAnnouncement() {
    ActuatorRoster roster = new ActuatorRoster();
    SixThrusters.announcements().forEach(each -> roster.see(each, 0));
    long before = roster.revision(750_000);
    SixThrusters.announcements().subList(1, 6).forEach(each -> roster.see(each, 500_000));

    assertThat(roster.revision(750_000)).isEqualTo(before);
    assertThat(roster.present(750_000)).hasSize(6);
    assertThat(roster.present(750_001)).hasSize(5);
    assertThat(roster.revision(750_001)).isNotEqualTo(before);
    assertThat(roster.lost(750_001)).containsExactly("T1");
    assertThat(roster.sound()).hasSize(6);

    roster.see(SixThrusters.announcements().get(0), 800_000);
    assertThat(roster.present(800_000)).hasSize(6);
    assertThat(roster.revision(800_000)).isEqualTo(before);
  }

  @Test
  void roster_withdrawnWeakenedOrFailed_countsByWhatIsLeft() {
    ActuatorRoster roster = new ActuatorRoster();
    List<ActuatorAnnouncement> all = SixThrusters.announcements();
    all.get(0).available(0.0);
    all.get(1).available(50.0);
    all.get(2).serviceName("Thruster 3");
    all.forEach(each -> roster.see(each, 0));
    roster.see(new HealthReport().serviceName("Thruster 3").status(ServiceStatus.FAILED));

    List<Effector> present = roster.present(1);

    assertThat(present).extracting(Effector::name).containsExactly("T2", "T4", "T5", "T6");
    assertThat(present.get(0).effect(DegreeOfFreedom.SURGE))
        .isCloseTo(0.5 * present.get(1).effect(DegreeOfFreedom.SURGE), within(1e-9));
    assertThat(roster.lost(1)).containsExactly("T1", "T3");
  }
}
