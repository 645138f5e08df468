package org.u2sa.control.fixedwing;

import org.u2sa.sim.aircraft.AircraftMotion;

/** What a flight was worth, by truth. */
final class FlightScore {
  private static final double ESTABLISHED_S = 20.0; // on a leg, after the turn into it

  private final Course course;
  final double[] missM;
  double crossSquares;
  long crossCount;
  double worstCrossM;
  double levelSquares;
  long levelCount;
  double worstLevelM;
  double worstBankDeg;
  double slowestMps = Double.POSITIVE_INFINITY;
  double highestAlphaDeg;
  double worstRunwayOffsetM;
  double worstClimbOutOffsetM;
  double climbOutLowestPitchDeg = 90.0;
  double liftOffS = Double.NaN;
  double liftOffKt;
  double groundRollM;
  double rejoinedGround;
  double betaSquares;
  double aileronTravel;
  double elevatorTravel;
  double throttleTravel;
  long flown;
  boolean crashed;
  boolean stalled;
  int legs;
  double endS;
  private int lastLeg = -1;
  private double legSinceS;
  private Surfaces last;

  FlightScore(Course course) {
    this.course = course;
    this.missM = new double[course.marks().size()];
    java.util.Arrays.fill(missM, Double.POSITIVE_INFINITY);
  }

  void note(
      AircraftMotion truth,
      FlightState state,
      Autopilot autopilot,
      LegFollower planner,
      Surfaces surfaces) {
    travel(surfaces);
    endS = truth.timeS();
    legs = planner.leg();
    crashed |= truth.crashed();
    stalled |= truth.stalled();
    for (int i = Math.max(0, legs - 1); i <= Math.min(legs, missM.length - 1); i++) {
      Course.Mark m = course.marks().get(i);
      missM[i] =
          Math.min(missM[i], Math.hypot(state.northM() - m.northM(), state.eastM() - m.eastM()));
    }
    FlightPhase phase = autopilot.phase();
    if (phase == FlightPhase.ROLL || phase == FlightPhase.ROTATE) {
      worstRunwayOffsetM = Math.max(worstRunwayOffsetM, Math.abs(state.northM()));
    }
    if (phase == FlightPhase.CLIMB_OUT) {
      if (Double.isNaN(liftOffS)) {
        liftOffS = truth.timeS();
        liftOffKt = truth.calibratedAirspeedMps() * 3600.0 / 1852.0;
        groundRollM = state.eastM();
      }
      if (truth.weightOnWheels()) {
        rejoinedGround += 1;
      }
      worstClimbOutOffsetM = Math.max(worstClimbOutOffsetM, Math.abs(state.northM()));
      climbOutLowestPitchDeg = Math.min(climbOutLowestPitchDeg, Math.toDegrees(state.pitchRad()));
    }
    if (Double.isNaN(liftOffS)) {
      return;
    }
    flown++;
    worstBankDeg = Math.max(worstBankDeg, Math.abs(Math.toDegrees(state.rollRad())));
    if (state.heightM() > 15) {
      slowestMps = Math.min(slowestMps, state.calibratedAirspeedMps());
      highestAlphaDeg = Math.max(highestAlphaDeg, Math.toDegrees(state.alphaRad()));
    }
    betaSquares += state.betaRad() * state.betaRad();
    if (legs != lastLeg) {
      lastLeg = legs;
      legSinceS = truth.timeS();
    }
    if (phase != FlightPhase.CRUISE
        || truth.timeS() - legSinceS < planner.turnS() + ESTABLISHED_S) {
      return;
    }
    double offset = planner.offsetM(state);
    crossSquares += offset * offset;
    crossCount++;
    worstCrossM = Math.max(worstCrossM, Math.abs(offset));
    boolean level =
        legs > 0
            && course.marks().get(legs).altitudeM() == course.marks().get(legs - 1).altitudeM();
    if (level) {
      double error = state.altitudeM() - course.marks().get(legs).altitudeM();
      levelSquares += error * error;
      levelCount++;
      worstLevelM = Math.max(worstLevelM, Math.abs(error));
    }
  }

  private void travel(Surfaces now) {
    if (last != null) {
      aileronTravel += Math.abs(now.aileron() - last.aileron());
      elevatorTravel += Math.abs(now.elevator() - last.elevator());
      throttleTravel += Math.abs(now.throttle() - last.throttle());
    }
    last = now;
  }

  double worstMissM() {
    double worst = 0.0;
    for (double m : missM) {
      worst = Math.max(worst, m);
    }
    return worst;
  }

  double crossRmsM() {
    return Math.sqrt(crossSquares / Math.max(1, crossCount));
  }

  double levelRmsM() {
    return Math.sqrt(levelSquares / Math.max(1, levelCount));
  }

  @Override
  public String toString() {
    return String.format(
        java.util.Locale.ROOT,
        "miss %5.1f xt %5.1f/%5.1f alt %4.1f/%4.1f bank %4.1f vmin %4.1f aoa %4.1f rwy %4.1f co %5.1f liftoff %4.1fs %4.1fkt %3.0fm bounce %.0f pitch≥%.1f beta %.2f travel/min ail %.1f ele %.1f thr %.1f legs %d end %.0fs%s%s",
        worstMissM(),
        crossRmsM(),
        worstCrossM,
        levelRmsM(),
        worstLevelM,
        worstBankDeg,
        slowestMps,
        highestAlphaDeg,
        worstRunwayOffsetM,
        worstClimbOutOffsetM,
        liftOffS,
        liftOffKt,
        groundRollM,
        rejoinedGround,
        climbOutLowestPitchDeg,
        Math.toDegrees(Math.sqrt(betaSquares / Math.max(1, flown))),
        aileronTravel * 60.0 / endS,
        elevatorTravel * 60.0 / endS,
        throttleTravel * 60.0 / endS,
        legs,
        endS,
        crashed ? " CRASHED" : "",
        stalled ? " STALLED" : "");
  }
}
