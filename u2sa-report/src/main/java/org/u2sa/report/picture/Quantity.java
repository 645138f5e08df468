package org.u2sa.report.picture;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.TrackSample;

/**
 * A quantity along a track, shown by colour or over time.
 *
 * @param name name, e.g. {@code altitude above sea level}
 * @param unit unit, e.g. {@code m}
 * @param low lower end of the displayed range
 * @param high upper end, more than {@code low}
 * @param of value of a sample; NaN if it has none
 * @param plannedName name of the planned value
 * @param planned planned value on the leg to a waypoint
 */
record Quantity(
    String name,
    String unit,
    double low,
    double high,
    ToDoubleFunction<TrackSample> of,
    String plannedName,
    Function<RunPlan.Waypoint, OptionalDouble> planned) {

  private static final double MAP_PER_ALTITUDE = 5.0; // ratio of their minimum extents
  private static final double MIN_SPEED_SPAN_MPS = 0.5;
  private static final double MIN_OFF_TRACK_M = 0.5;

  static Quantity onMap(RunPlan plan, List<TrackSample> track) {
    return switch (plan.domain()) {
      case AIR, SMALL_AIRCRAFT -> altitude(plan, track);
      case GROUND, WATER, UNDERWATER -> speed(track);
    };
  }

  static Quantity overTime(RunPlan plan, List<TrackSample> track) {
    return switch (plan.domain()) {
      case AIR, SMALL_AIRCRAFT -> altitude(plan, track);
      case UNDERWATER -> height(track);
      case GROUND, WATER -> offTrack(track).orElseGet(() -> speed(track));
    };
  }

  private static Quantity altitude(RunPlan plan, List<TrackSample> track) {
    DoubleStream planned =
        Stream.concat(
                plan.home().stream().map(RunPlan.Start::altitudeM),
                plan.waypoints().stream()
                    .filter(w -> w.altitudeM().isPresent())
                    .map(w -> w.altitudeM().getAsDouble()))
            .mapToDouble(Double::doubleValue);
    double[] all =
        DoubleStream.concat(planned, track.stream().mapToDouble(TrackSample::altitudeM))
            .sorted()
            .toArray();
    double low = all.length == 0 ? 0.0 : all[0];
    double high = all.length == 0 ? 0.0 : all[all.length - 1];
    return new Quantity(
        "altitude above sea level",
        "m",
        low,
        Math.max(high, low + plan.domain().leastMapM() / MAP_PER_ALTITUDE),
        TrackSample::altitudeM,
        "altitude of the next waypoint",
        RunPlan.Waypoint::altitudeM);
  }

  /** Height relative to the water's surface, which is at altitude 0. */
  private static Quantity height(List<TrackSample> track) {
    double low = track.stream().mapToDouble(TrackSample::altitudeM).min().orElse(0.0);
    return new Quantity(
        "height relative to the surface",
        "m",
        Math.min(low, -1.0),
        0.0,
        TrackSample::altitudeM,
        "height of the next waypoint",
        RunPlan.Waypoint::altitudeM);
  }

  private static Quantity speed(List<TrackSample> track) {
    double most = track.stream().mapToDouble(TrackSample::groundSpeedMps).max().orElse(0.0);
    return new Quantity(
        "speed over ground",
        "m/s",
        0.0,
        Math.max(most, MIN_SPEED_SPAN_MPS),
        TrackSample::groundSpeedMps,
        "",
        waypoint -> OptionalDouble.empty());
  }

  /** Distance from the line; empty if the vehicle never was on its way along one. */
  private static Optional<Quantity> offTrack(List<TrackSample> track) {
    OptionalDouble most =
        track.stream()
            .map(TrackSample::crossTrackM)
            .flatMapToDouble(OptionalDouble::stream)
            .map(Math::abs)
            .max();
    if (most.isEmpty()) {
      return Optional.empty();
    }
    double bound = Math.max(MIN_OFF_TRACK_M, most.getAsDouble());
    return Optional.of(
        new Quantity(
            "distance to the right of the line",
            "m",
            -bound,
            bound,
            sample -> sample.crossTrackM().orElse(Double.NaN),
            "line to the next waypoint",
            waypoint -> OptionalDouble.of(0.0)));
  }
}
