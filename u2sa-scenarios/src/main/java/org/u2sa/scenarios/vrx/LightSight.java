package org.u2sa.scenarios.vrx;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleFunction;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Simulated recognition of a light buoy's colour by cameras that look ahead and to both sides. The
 * buoy shows three colours for one second each, then stays dark for two (LightBuoyPlugin.cc); one
 * look in ten yields a wrong colour or none.
 */
final class LightSight implements LightReader.Sight {
  private static final double REACH_M = 25.0;
  private static final double VIEW_RAD = Math.toRadians(240.0);
  private static final double WRONG = 0.05;
  private static final double UNSEEN = 0.05;
  private static final int STATES = 5;
  private static final List<Colour> COLOURS =
      List.of(Colour.RED, Colour.GREEN, Colour.BLUE, Colour.YELLOW);

  private final Docking docking;
  private final DoubleFunction<VehicleTruth> truth; // by time [s]
  private final Random random;

  LightSight(Docking docking, DoubleFunction<VehicleTruth> truth, long seed) {
    this.docking = docking;
    this.truth = truth;
    random = new Random(seed);
  }

  @Override
  public Optional<Colour> colour(double timeS) {
    VehicleTruth boat = truth.apply(timeS);
    Point way = docking.light().minus(boat.position());
    double bearing = Math.atan2(way.x(), way.y()) - boat.headingRad();
    boolean isInView =
        Math.hypot(way.x(), way.y()) <= REACH_M
            && Math.abs(Math.IEEEremainder(bearing, 2.0 * Math.PI)) <= VIEW_RAD / 2.0;
    int state = (int) (timeS % STATES);
    double chance = random.nextDouble();
    if (!isInView || state >= docking.sequence().size() || chance < UNSEEN) {
      return Optional.empty();
    }
    return Optional.of(
        chance < UNSEEN + WRONG
            ? COLOURS.get(random.nextInt(COLOURS.size()))
            : docking.sequence().get(state));
  }
}
