package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.flight.Catapult;
import org.u2sa.sim.flight.LandingLeg;
import org.u2sa.sim.flight.MassProperties;

/** Common elements of small aircraft in vehicle files: body (about its centre of gravity), legs. */
final class AircraftParts {
  private static final double FAR_M = 100.0;
  private static final int MAX_LEGS = 32;
  private static final double STEEPEST = 2.0; // wheel angle per rudder angle

  private AircraftParts() {}

  /** The body, whose reference point must be its centre of gravity. */
  static MassProperties mass(FileElement file, Body body) {
    requireAtGravityCentre(file, body);
    double product = file.number("productOfInertia", "kg m^2", -1e6, 1e6, 0.0);
    return file.made(() -> new MassProperties(body.massKg(), body.inertia(), product));
  }

  static void requireAtGravityCentre(FileElement file, Body body) {
    if (body.gravityCentre().distance() > 0.0) {
      throw file.xml()
          .error(
              "the body has a gravityCentre of "
                  + body.gravityCentre()
                  + " m; expected none: an aircraft's reference point is its centre of gravity");
    }
  }

  /**
   * Landing gear.
   *
   * @param hasRudder whether wheels can be linked to a rudder
   */
  static List<LandingLeg> legs(FileElement file, boolean hasRudder) {
    List<LandingLeg> legs = new ArrayList<>();
    for (String kind : List.of("skid", "wheel")) {
      for (FileElement each : file.parts(kind)) {
        Point position = each.vector("position", "m", -FAR_M, FAR_M);
        boolean rolls = kind.equals("wheel");
        boolean steers = hasRudder && rolls;
        double steering = steers ? each.number("steering", "1", -STEEPEST, STEEPEST, 0.0) : 0.0;
        legs.add(new LandingLeg(position, rolls, steering));
        each.end();
      }
    }
    if (legs.size() > MAX_LEGS || legs.size() == 1 || legs.size() == 2) {
      throw file.xml()
          .error("has " + legs.size() + " <skid> and <wheel>; expected none, or 3…" + MAX_LEGS);
    }
    return List.copyOf(legs);
  }

  /** How the aircraft is launched; empty if it starts on the ground. */
  static Optional<Catapult> catapult(FileElement file) {
    return file.optionalPart("catapult").map(AircraftParts::thrower);
  }

  private static Catapult thrower(FileElement file) {
    return file.complete(
        () ->
            new Catapult(
                file.positive("speed", "m/s", 200.0),
                file.number("angle", "rad", 0.0, Math.PI / 3.0),
                file.number("height", "m", 0.0, 100.0),
                file.number("stroke", "m", 0.1, 100.0, 2.0)));
  }

  /** Height of the centre of gravity above the landing gear's contact [m]; 0 without legs. */
  static double standsM(List<LandingLeg> legs) {
    return legs.stream().mapToDouble(leg -> leg.place().z()).max().orElse(0.0);
  }
}
