package org.u2sa.world.egocentric;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.Sighting;

/**
 * Remembers stationary objects relative to the vehicle, without a State Estimator (thesis 4.3.2):
 * each sighting corrects an object's position, and between sightings it is propagated by the turn
 * rate of an IMU and the speed of a velocity log. Objects are published in BODY, as for a level
 * vehicle.
 */
public final class EgocentricModeller implements Modeller {
  private static final double MIN_SHARE = 0.1; // weight of a sighting in the position
  private static final double RANGE_SHARE = 0.125; // error of the range

  private record Variables(
      @Variable(unit = "s", min = 0.1, max = 3600, ifAbsent = 20)
          @Description("EGOCENTRIC: time after its last sighting at which an object is dropped.")
          double egocentricMemory,
      @Variable(unit = "m", min = 0.01, max = 1000, ifAbsent = 1.5)
          @Description(
              "EGOCENTRIC: association distance between a sighting and a known object of its type, plus an eighth of the range.")
          double egocentricGate) {}

  /** An object in the frame of {@link OwnMotion}. */
  private static final class Remembered {
    private ObjectDescription object;
    private int sightings = 1;
    private long seenMicros;

    Remembered(ObjectDescription object, long seenMicros) {
      this.object = object;
      this.seenMicros = seenMicros;
    }

    void see(ObjectDescription seen, boolean isUnsure, long micros) {
      sightings++;
      double share = isUnsure ? 1.0 : Math.max(MIN_SHARE, 1.0 / sightings);
      Point before = object.center();
      Point at = before.plus(seen.center().minus(before).times(share));
      object = seen.copy().x(at.x()).y(at.y()).z(at.z());
      seenMicros = micros;
    }
  }

  private final Settings<Variables> tuning;
  private final OwnMotion motion = new OwnMotion();
  private final List<Remembered> all = new ArrayList<>();
  private boolean knowsSpeed;

  /**
   * @param configuration configuration of the World Modeler
   */
  public EgocentricModeller(Configurator configuration) {
    tuning = configuration.settings(Variables.class);
  }

  @Override
  public boolean needsSensedState() {
    return true;
  }

  @Override
  public void sensed(StateInformation measured) {
    measured.timestamp().ifPresent(micros -> motion.sensed(measured, micros));
  }

  @Override
  public void objects(List<ObjectDescription> seen, Sighting sighting) {
    StateInformation vehicle = motion.at(sighting.micros());
    List<Remembered> free = new ArrayList<>(all);
    for (ObjectDescription each : seen) {
      if (each.referenceFrame().equals(ReferenceFrame.BODY)) {
        ObjectDescription placed = each.in(ReferenceFrame.LOCAL_NED, vehicle);
        boolean isUnsure = isUnsure(each);
        double gateM = tuning.get().egocentricGate() + RANGE_SHARE * each.center().distance();
        Optional<Remembered> known =
            nearest(free, placed, isUnsure ? Double.POSITIVE_INFINITY : gateM);
        if (known.isPresent()) {
          known.get().see(placed, isUnsure, sighting.micros());
          free.remove(known.get());
        } else {
          all.add(new Remembered(placed, sighting.micros()));
        }
      }
    }
  }

  /** Whether only the direction is measured; then only the newest sighting counts. */
  private boolean isUnsure(ObjectDescription object) {
    double mostM = tuning.get().egocentricGate();
    return object
        .motion()
        .sigma()
        .filter(sigma -> Math.max(Math.max(sigma.x(), sigma.y()), sigma.z()) > mostM)
        .isPresent();
  }

  private static Optional<Remembered> nearest(
      List<Remembered> free, ObjectDescription placed, double gateM) {
    Point at = placed.center();
    return free.stream()
        .filter(each -> each.object.objectType().equals(placed.objectType()))
        .filter(each -> each.object.center().distanceTo(at) < gateM)
        .min(Comparator.comparingDouble(each -> each.object.center().distanceTo(at)));
  }

  @Override
  public List<ObjectDescription> objects(Sighting now) {
    knowsSpeed = motion.knowsSpeed(now.micros());
    long oldest = now.micros() - Clock.micros(tuning.get().egocentricMemory());
    all.removeIf(each -> each.seenMicros < oldest);
    StateInformation level = motion.at(now.micros()).copy().phi(0.0).theta(0.0);
    List<ObjectDescription> objects = new ArrayList<>();
    all.forEach(each -> objects.add(each.object.in(ReferenceFrame.BODY, level)));
    return objects;
  }

  @Override
  public String remark() {
    return all.size() + " objects remembered" + (knowsSpeed ? "" : "; speed unknown");
  }
}
