package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.LongRange;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;

/** A vehicle that brakes or turns as it promised never leaves its fence. */
class FenceProperties {
  private static final double STEP_S = 0.1;
  private static final double LONGEST_S = 3600.0;
  private static final GeometryFactory GEOMETRY = new GeometryFactory();

  /** A star of twelve corners around the origin, rarely convex, with a hole to keep out of. */
  private static Fence fence(SplittableRandom random, double sizeM) {
    Coordinate[] corners = new Coordinate[13];
    for (int i = 0; i < 12; i++) {
      double radius = sizeM * (0.6 + 0.4 * random.nextDouble());
      double angle = 2.0 * Math.PI * i / 12;
      corners[i] = new Coordinate(radius * Math.cos(angle), radius * Math.sin(angle));
    }
    corners[12] = corners[0].copy();
    Polygon out =
        (Polygon) GEOMETRY.createPoint(new Coordinate(0.3 * sizeM, 0.0)).buffer(0.05 * sizeM);
    return new Fence(
        Optional.empty(),
        Optional.of(GEOMETRY.createPolygon(corners)),
        List.of(out),
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        List.of());
  }

  private static Point velocity(double speed, double course) {
    return Point.of(speed * Math.sin(course), speed * Math.cos(course), 0.0);
  }

  @Property(tries = 300)
  void region_anyVelocity_liesWithinReachAndIsAllowedWhereThatIsClear(
      @ForAll @LongRange(min = 0, max = 1_000_000) long seed,
      @ForAll @DoubleRange(min = 0.0, max = 60.0) double speed,
      @ForAll boolean turns) {
    SplittableRandom random = new SplittableRandom(seed);
    Manoeuvre promised = new Manoeuvre(turns, 2.0, 1.5, 0.5, 20.0, 4.0, 1.0, 5.0);
    double reachM = promised.reachM(speed);
    Fence fence = fence(random, 3.0 * reachM + 1.0);
    Point place =
        Point.of(reachM * (random.nextDouble() - 0.5), reachM * (random.nextDouble() - 0.5), 0.0);
    Geometry region = promised.region(place, velocity(speed, 7.0 * random.nextDouble()));
    for (Coordinate corner : region.getCoordinates()) {
      assertThat(Math.hypot(corner.x - place.x(), corner.y - place.y()))
          .isLessThanOrEqualTo(reachM + 1e-6);
    }
    if (fence.allows(place) && reachM + 1e-6 < fence.clearanceM(place)) {
      assertThat(fence.allows(region)).isTrue();
    }
  }

  @Property(tries = 300)
  void turner_onceItIsTooNear_turnsRoundInsideByEitherSideOrTheOneWithRoom(
      @ForAll @LongRange(min = 0, max = 1_000_000) long seed,
      @ForAll boolean oneSide,
      @ForAll @DoubleRange(min = 10.0, max = 60.0) double speed,
      @ForAll @DoubleRange(min = 0.2, max = 0.7) double bank,
      @ForAll @DoubleRange(min = 0.0, max = 8.0) double wind) {
    SplittableRandom random = new SplittableRandom(seed);
    double reaction = 3.0;
    Manoeuvre promised =
        new Manoeuvre(true, reaction + 2.0 * STEP_S, 1.0, bank, 0.0, wind, 1.0, 5.0);
    Fence fence =
        fence(
            random,
            20.0 * promised.turnRadiusM(speed) + 10.0 * promised.driftM(speed) + 40.0 * speed);
    double course = 2.0 * Math.PI * random.nextDouble();
    double windTo = 2.0 * Math.PI * random.nextDouble();
    double east = 0.0;
    double north = 0.0;
    double turned = 0.0;
    double triggered = Double.NaN;
    double side = random.nextBoolean() ? 1.0 : -1.0;
    for (double t = 0.0; t < LONGEST_S && turned < Math.PI; t += STEP_S) {
      Point here = Point.of(east, north, 0.0);
      double vEast = speed * Math.sin(course) + wind * Math.sin(windTo);
      double vNorth = speed * Math.cos(course) + wind * Math.cos(windTo);
      assertThat(fence.allows(here)).as("inside at %s s", t).isTrue();
      Point over = Point.of(vEast, vNorth, 0.0);
      if (Double.isNaN(triggered) && !oneSide && !fence.allows(promised.region(here, over))) {
        triggered = t;
      } else if (Double.isNaN(triggered) && oneSide) {
        boolean right = fence.allows(promised.regionToOneSide(here, over, 1.0));
        boolean left = fence.allows(promised.regionToOneSide(here, over, -1.0));
        triggered = right || left ? Double.NaN : t;
        side = right ? 1.0 : left ? -1.0 : side; // the last one with room
      }
      if (t - triggered >= reaction - 1e-6) { // false for NaN
        double rate = Gravity.STANDARD_MPS2 * Math.tan(bank) / speed;
        course += side * rate * STEP_S;
        turned += rate * STEP_S;
      }
      east += vEast * STEP_S;
      north += vNorth * STEP_S;
    }
    assertThat(turned).as("it came to the fence").isGreaterThanOrEqualTo(Math.PI);
  }

  @Property(tries = 300)
  void braker_onceItIsTooNear_standsInside(
      @ForAll @LongRange(min = 0, max = 1_000_000) long seed,
      @ForAll @DoubleRange(min = 0.5, max = 20.0) double speed,
      @ForAll @DoubleRange(min = 0.2, max = 5.0) double braking) {
    SplittableRandom random = new SplittableRandom(seed);
    double reaction = 1.0;
    Manoeuvre promised =
        new Manoeuvre(false, reaction + 2.0 * STEP_S, braking, 0.4, 0.0, 0.0, 1.0, 5.0);
    Fence fence = fence(random, 6.0 * (promised.stoppingM(speed) + 2.0 * speed));
    Point velocity = velocity(speed, 2.0 * Math.PI * random.nextDouble());
    double way = 0.0;
    double now = speed;
    double triggered = Double.NaN;
    for (double t = 0.0; t < LONGEST_S && now > 0.0; t += STEP_S) {
      Point here = Point.of(way * velocity.x() / speed, way * velocity.y() / speed, 0.0);
      assertThat(fence.allows(here)).as("inside at %s s", t).isTrue();
      if (Double.isNaN(triggered) && !fence.allows(promised.region(here, velocity))) {
        triggered = t;
      }
      double before = now;
      if (t - triggered >= reaction - 1e-6) { // false for NaN
        now = Math.max(0.0, now - braking * STEP_S);
      }
      way += (before + now) / 2.0 * STEP_S;
    }
    assertThat(now).as("it came to the fence").isZero();
  }

  /**
   * The drift acts aside while it brakes, and in full until it holds; not back where it came from.
   */
  @Property(tries = 300)
  void drifter_onceItIsTooNear_holdsInside(
      @ForAll @LongRange(min = 0, max = 1_000_000) long seed,
      @ForAll @DoubleRange(min = 0.0, max = 1.0) double wind,
      @ForAll @DoubleRange(min = 1.0, max = 5.0) double speed,
      @ForAll @DoubleRange(min = 0.2, max = 2.0) double braking) {
    SplittableRandom random = new SplittableRandom(seed);
    double reaction = 1.0;
    double held = 6.0;
    Manoeuvre promised =
        new Manoeuvre(false, reaction + 2.0 * STEP_S, braking, 0.4, 0.0, wind, 1.0, held);
    Fence fence = fence(random, 6.0 * (promised.wayToStopM(speed) + 2.0 * speed));
    double course = 2.0 * Math.PI * random.nextDouble();
    double windTo = course + Math.PI * (random.nextDouble() - 0.5);
    double aside = wind * Math.sin(windTo - course);
    double east = 0.0;
    double north = 0.0;
    double ahead = speed;
    double triggered = Double.NaN;
    double stands = 0.0;
    for (double t = 0.0; t < LONGEST_S && stands < held - STEP_S; t += STEP_S) {
      Point here = Point.of(east, north, 0.0);
      assertThat(fence.allows(here)).as("inside at %s s", t).isTrue();
      Point over = velocity(ahead, course);
      if (Double.isNaN(triggered) && !fence.allows(promised.region(here, over))) {
        triggered = t;
      }
      boolean brakes = t - triggered >= reaction - 1e-6; // false for NaN
      double before = ahead;
      if (brakes) {
        ahead = Math.max(0.0, ahead - braking * STEP_S);
      }
      double onward = (before + ahead) / 2.0;
      double sideways = brakes ? aside : 0.0;
      if (before == 0.0) {
        onward = wind * Math.cos(windTo - course);
        stands += STEP_S;
      }
      east += (onward * Math.sin(course) + sideways * Math.cos(course)) * STEP_S;
      north += (onward * Math.cos(course) - sideways * Math.sin(course)) * STEP_S;
    }
    assertThat(stands).as("it came to the fence").isGreaterThanOrEqualTo(held - STEP_S);
  }
}
