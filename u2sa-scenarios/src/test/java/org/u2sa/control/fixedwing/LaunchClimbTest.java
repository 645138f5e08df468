package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.control.Transfer;
import org.u2sa.service.handover.HandOver;

/** An aeroplane on a catapult at an altitude of 300 m that flies from 12 m/s. */
class LaunchClimbTest {
  private static final double STALL_MPS = 12.0;
  private static final double USUAL_RAD = 0.7;

  private final AirbornePhases.LaunchClimb climb = new AirbornePhases.LaunchClimb();

  private double demandM = 360.0;

  private double limitRad(double speedMps, double altitudeM) {
    climb.see(States.level().speed(speedMps).altitude(altitudeM).now(), STALL_MPS, demandM);
    return climb.bankLimitRad(USUAL_RAD);
  }

  @Test
  void isUnderWay_lowMission_endsAtItsAltitude() {
    demandM = 310.0;
    limitRad(0.0, 300.0);
    assertThat(climb.topM()).isLessThanOrEqualTo(310.0);
    limitRad(15.0, 308.0);
    assertThat(climb.isUnderWay()).isTrue();
    limitRad(15.0, 309.5);
    assertThat(climb.isUnderWay()).isFalse();
  }

  /** The planner's points rise with the aeroplane towards a high and distant waypoint. */
  @Test
  void isUnderWay_demandRisesWithTheAeroplane_endsWhenClear() {
    limitRad(0.0, 300.0);
    for (double altitudeM = 301.0; altitudeM < 320.0; altitudeM += 1.0) {
      demandM = altitudeM + 2.4;
      limitRad(15.0, altitudeM);
      assertThat(climb.isUnderWay()).isTrue();
    }
    limitRad(15.0, 320.0);
    assertThat(climb.isUnderWay()).isFalse();
  }

  @Test
  void isUnderWay_missionBelowTheLauncher_climbsAndEnds() {
    demandM = 250.0;
    limitRad(0.0, 300.0);
    assertThat(climb.topM()).isGreaterThan(320.0);
    limitRad(15.0, 319.0);
    assertThat(climb.isUnderWay()).isTrue();
    limitRad(15.0, 320.0);
    assertThat(climb.isUnderWay()).isFalse();
  }

  @Test
  void bankLimitRad_launched_risesWithHeightUntilClear() {
    assertThat(limitRad(0.0, 300.0)).isCloseTo(Math.toRadians(5.0), within(1e-9));
    assertThat(climb.isUnderWay()).isTrue();
    double halfWay = limitRad(15.0, 310.0);
    assertThat(halfWay).isBetween(0.3, 0.5);
    assertThat(limitRad(15.0, 299.0)).isCloseTo(Math.toRadians(5.0), within(1e-9));
    assertThat(limitRad(15.0, 320.0)).isEqualTo(USUAL_RAD);
    assertThat(limitRad(15.0, 305.0)).as("clear once, it may fly low").isEqualTo(USUAL_RAD);
    assertThat(climb.isUnderWay()).isFalse();
  }

  @Test
  void bankLimitRad_firstSeenInFlight_isUsual() {
    assertThat(limitRad(15.0, 300.0)).isEqualTo(USUAL_RAD);
  }

  @Test
  void bankLimitRad_standsOverGroundInTheWind_isUsual() {
    climb.see(States.level().speed(15.0).ground(0.0, 1.0).now(), STALL_MPS, demandM);

    assertThat(climb.bankLimitRad(USUAL_RAD)).isEqualTo(USUAL_RAD);
  }

  @Test
  void transfer_duringTheClimb_goesOn() {
    limitRad(0.0, 300.0);
    double before = limitRad(15.0, 304.0);
    HandOver state = new HandOver("test");
    climb.transfer(Transfer.saving(state));
    AirbornePhases.LaunchClimb successor = new AirbornePhases.LaunchClimb();
    successor.transfer(Transfer.restoring(state));

    assertThat(successor.bankLimitRad(USUAL_RAD)).isEqualTo(before);
    successor.see(States.level().speed(15.0).altitude(320.0).now(), STALL_MPS, demandM);
    assertThat(successor.isUnderWay()).isFalse();
  }
}
