package org.u2sa.world.landmark;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.messages.LandmarkSighting;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.Sighting;

/**
 * Recognises sighted objects as landmarks, i.e. objects of WORLD or seen before, and publishes
 * their range and bearing as measurements for the State Estimator (thesis 4.3.1.2). Sightings are
 * associated by UID or, without one, by type and position if only one landmark fits.
 */
public final class LandmarkModeller implements Modeller {
  /** Prefix of the measurements' sources, followed by the sensor's name. */
  public static final String SOURCE = "Landmarks";

  private static final double AMBIGUOUS =
      2.0; // ratio test: the second nearest must be this many times farther
  private static final double NEAREST_M = 0.1;
  private static final long RETURN_MICROS = 15_000_000L; // delay from learning it to using it
  private static final int MAX_LANDMARKS = 2000;

  private final Settings<LandmarkVariables> settings;
  private final Map<String, Landmark> landmarks = new LinkedHashMap<>();
  private final List<StateInformation> corrections = new ArrayList<>();
  private List<ObjectDescription> told = List.of();
  private MapFrame frame = MapFrame.BODY;
  private long used;
  private long unknown;
  private int learnt;

  /**
   * @param configuration configuration of the World Modeler
   */
  public LandmarkModeller(Configurator configuration) {
    settings = configuration.settings(LandmarkVariables.class);
  }

  @Override
  public void known(List<ObjectDescription> objects, Sighting since) {
    told = List.copyOf(objects);
    landmarks.values().removeIf(Landmark::isKnown);
    LandmarkVariables now = settings.get();
    for (ObjectDescription each : objects) {
      Optional<ObjectDescription> placed = frame.placed(each, Optional.empty());
      if (serves(each) && placed.isPresent() && !each.uid().isEmpty()) {
        Point place = frame.metres(placed.get().center());
        landmarks.put(
            each.uid(), Landmark.known(each.uid(), each.objectType(), place, now.landmarkSigma()));
      }
    }
  }

  @Override
  public void objects(List<ObjectDescription> seen, Sighting sighting) {
    for (ObjectDescription each : seen) {
      if (each.referenceFrame().isBody()) {
        if (sighting.vehicle().isPresent()) {
          object(each, sighting);
        } else {
          named(each, sighting.micros());
        }
      }
    }
  }

  /** Associates by UID alone when the vehicle's position is lost; assumes a level vehicle. */
  private void named(ObjectDescription object, long micros) {
    ObjectDescription frd = object.in(ReferenceFrame.BODY_FRD, null);
    double range = Math.hypot(frd.x(), frd.y());
    Optional<ObjectDescription> known =
        told.stream()
            .filter(each -> !each.uid().isEmpty() && each.uid().equals(object.uid()))
            .filter(each -> !each.referenceFrame().isBody() && serves(each))
            .findFirst();
    if (known.isEmpty() || range < NEAREST_M) {
      unknown++;
      return;
    }
    double own = settings.get().landmarkSigma() * settings.get().landmarkSigma();
    Errors errors = errors(frd);
    LandmarkSighting measured =
        measured(
            Point.of(known.get().x(), known.get().y(), 0.0),
            range,
            StrictMath.atan2(frd.y(), frd.x()),
            errors,
            own);
    publish(measured, known.get().referenceFrame(), object.sensorName(), micros);
  }

  /** Variances of a sighting along and across the line of sight [m²]. */
  private record Errors(double along, double across) {}

  private Errors errors(ObjectDescription frd) {
    double usual = settings.get().sightingSigma();
    Point sigma = frd.motion().sigma().orElse(Point.of(usual, usual, usual));
    double range = Math.max(NEAREST_M, Math.hypot(frd.center().x(), frd.center().y()));
    double c = frd.center().x() / range;
    double s = frd.center().y() / range;
    return new Errors(
        c * c * sigma.x() * sigma.x() + s * s * sigma.y() * sigma.y(),
        s * s * sigma.x() * sigma.x() + c * c * sigma.y() * sigma.y());
  }

  private static LandmarkSighting measured(
      Point place, double range, double clockwise, Errors errors, double placeVariance) {
    return new LandmarkSighting()
        .landmarkX(place.x())
        .landmarkY(place.y())
        .range(range)
        .rangeSigma(Math.sqrt(errors.along() + placeVariance))
        .bearing(Math.IEEEremainder(clockwise, 2.0 * Math.PI))
        .bearingSigma(Math.sqrt(errors.across() + placeVariance) / range);
  }

  private void publish(
      LandmarkSighting measured, ReferenceFrame where, String sensor, long micros) {
    measured.referenceFrame(where).sensorName(SOURCE + " " + sensor).timestamp(micros);
    corrections.add(measured);
    used++;
  }

  private boolean serves(ObjectDescription object) {
    Set<String> types = settings.get().types();
    return types.isEmpty() || types.contains(object.objectType());
  }

  private void object(ObjectDescription object, Sighting sighting) {
    LandmarkVariables now = settings.get();
    StateInformation vehicle = sighting.vehicle().orElseThrow();
    ObjectDescription frd = object.in(ReferenceFrame.BODY_FRD, null);
    Point level =
        frame
            .mapFromFrd(sighting.vehicle())
            .times(frd.center()); // relative to the vehicle, in the map's axes
    double range = Math.hypot(level.x(), level.y());
    if (range < NEAREST_M) {
      return;
    }
    Errors errors = errors(frd);
    double largest = Math.max(errors.along(), errors.across());
    Point origin = frame.vehicle(sighting.vehicle());
    Point at = Point.of(origin.x() + level.x(), origin.y() + level.y(), 0.0);
    double turned = range * vehicle.number(StateField.PSI_SIGMA).orElse(0.0);
    double x = vehicle.number(StateField.X_SIGMA).orElse(0.0);
    double y = vehicle.number(StateField.Y_SIGMA).orElse(0.0);
    double placed = Math.max(x * x, y * y) + turned * turned; // due to the vehicle's pose
    Optional<Landmark> landmark = landmark(object, at, placed + largest);
    if (landmark.isEmpty()) {
      unknown++;
      learn(object, at, placed, largest);
      return;
    }
    Landmark known = landmark.get();
    if (!known.isLearnt()) {
      known.learn(at, placed, largest, sighting.micros());
      learnt += known.isLearnt() ? 1 : 0;
      return;
    }
    if (!known.isKnown() && sighting.micros() - known.learntMicros() < RETURN_MICROS) {
      return; // it would only repeat the vehicle's pose
    }
    Point nose = frame.mapFromFrd(sighting.vehicle()).times(Point.of(1.0, 0.0, 0.0));
    double bearing = StrictMath.atan2(level.y(), level.x()) - StrictMath.atan2(nose.y(), nose.x());
    double clockwise = frame.up() > 0.0 ? -bearing : bearing;
    double own = known.use(sighting.micros(), learnt);
    Point place = frame.point(known.place());
    publish(
        measured(place, range, clockwise, errors, own),
        frame.frame(),
        object.sensorName(),
        sighting.micros());
  }

  private Optional<Landmark> landmark(ObjectDescription object, Point at, double variance) {
    Landmark named = landmarks.get(object.uid());
    if (named != null && !object.uid().isEmpty()) {
      return Optional.of(named);
    }
    boolean hasName = // otherwise the UID is only a number assigned by the sensor
        !object.uid().isEmpty()
            && (settings.get().types().isEmpty() || settings.get().learnLandmarks());
    Landmark best = null;
    double least = Double.POSITIVE_INFINITY;
    double second = Double.POSITIVE_INFINITY;
    for (Landmark each : landmarks.values()) {
      if (hasName || object.objectType().isEmpty() || !each.type.equals(object.objectType())) {
        continue;
      }
      double away = at.distanceTo(Point.of(each.place().x(), each.place().y(), 0.0));
      double sigmas = away / Math.sqrt(variance + each.variance());
      if (sigmas < least) {
        second = least;
        least = sigmas;
        best = each;
      } else {
        second = Math.min(second, sigmas);
      }
    }
    boolean isClear = least < settings.get().landmarkGate() && second > AMBIGUOUS * least;
    return isClear && second > settings.get().landmarkGate() ? Optional.of(best) : Optional.empty();
  }

  private void learn(ObjectDescription object, Point at, double placed, double own) {
    boolean learns =
        settings.get().learnLandmarks()
            && settings.get().types().contains(object.objectType())
            && landmarks.size() < MAX_LANDMARKS;
    if (!learns) {
      return;
    }
    boolean isNear =
        landmarks.values().stream()
            .filter(each -> each.type.equals(object.objectType()))
            .anyMatch(
                each ->
                    object.uid().isEmpty()
                        && at.distanceTo(each.place())
                            < 6.0 * Math.sqrt(placed + own + each.variance()));
    if (!isNear) { // otherwise ambiguous
      String name = object.uid().isEmpty() ? "seen " + landmarks.size() : object.uid();
      landmarks.put(name, Landmark.seen(name, object.objectType(), at, placed, own));
    }
  }

  @Override
  public List<StateInformation> corrections() {
    List<StateInformation> all = List.copyOf(corrections);
    corrections.clear();
    return all;
  }

  @Override
  public void enter(MapFrame newFrame, Sighting now) {
    frame = newFrame;
    landmarks.clear();
    learnt = 0;
    known(told, now);
  }

  @Override
  public String remark() {
    return landmarks.size()
        + " landmarks, "
        + learnt
        + " of them learnt, "
        + used
        + " sightings used, "
        + unknown
        + " of others";
  }
}
