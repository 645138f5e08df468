package org.u2sa.report.export;

import java.io.IOException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.recorder.playback.RecordedSpan;

/** Geographic content of a recording: tracks and goals. */
public final class GeoRun {
  private static final long NANOS = 1_000_000_000L;
  private static final double NANOS_PER_MICRO = 1e3;
  private static final double TURN_DEG = 360.0;

  private final Map<String, List<Fix>> tracks = new LinkedHashMap<>();
  private final Map<String, Goal> goals = new LinkedHashMap<>();

  /**
   * A position of the vehicle.
   *
   * @param nanos time of measurement [ns of the run's clock]
   * @param longitudeDeg east positive [deg, -180…180]
   * @param altitudeM altitude above mean sea level [m]; empty if unknown
   */
  record Fix(long nanos, double longitudeDeg, double latitudeDeg, OptionalDouble altitudeM) {
    /** Whether the run is in simulated time, which starts in 1970. */
    Instant time() {
      return Instant.ofEpochSecond(Math.floorDiv(nanos, NANOS), Math.floorMod(nanos, NANOS));
    }
  }

  /** A goal in its last recorded state; altitude above mean sea level [m], empty for any. */
  record Goal(
      String name,
      double longitudeDeg,
      double latitudeDeg,
      OptionalDouble altitudeM,
      double thresholdM,
      boolean isReached) {}

  private GeoRun() {}

  /**
   * Reads a recording.
   *
   * @param channels channels of the states; empty for state
   * @param everyS minimum time between two positions of a track [s]
   * @throws BadInputException if there is no state with a geographic position
   */
  public static GeoRun read(
      RecordedMessages recording, RecordedSpan span, List<String> channels, double everyS)
      throws IOException {
    List<String> ofStates = channels.isEmpty() ? List.of(Channels.STATE.name()) : channels;
    Predicate<McapChannel> states = recording.channels(ofStates);
    List<String> ofGoals = List.of(Channels.GOALS.name(), Channels.GOAL_REPORTS.name());
    GeoRun run = new GeoRun();
    Spacing spacing = new Spacing(everyS);
    recording.forEach(
        channel ->
            states.test(channel)
                || recording.topic(channel).filter(t -> ofGoals.contains(t.channel())).isPresent(),
        span,
        (topic, message, nanos) -> {
          if (message instanceof GoalList list) {
            list.goals().forEach(run::take);
          } else if (message instanceof GoalInformation goal) {
            run.take(goal);
          } else if (message instanceof StateInformation state
              && ofStates.contains(topic.channel())) {
            run.take(topic, state, nanos, spacing);
          }
        });
    if (run.tracks.isEmpty()) {
      throw new BadInputException(
          String.format(
              "no message on %s has a position on the earth (frame GLOBAL or UTM, x and y); choose "
                  + "other channels with --channel",
              String.join(", ", ofStates)));
    }
    return run;
  }

  private void take(Topic topic, StateInformation state, long logNanos, Spacing spacing) {
    boolean isPlace =
        state.referenceFrame().isEarth() && state.x().isPresent() && state.y().isPresent();
    String source = topic.source().isEmpty() ? state.sensorName() : topic.source();
    String name = topic.channel() + (source.isEmpty() ? "" : " " + source);
    if (isPlace && spacing.takes(name, logNanos / (double) NANOS)) {
      tracks
          .computeIfAbsent(name, key -> new ArrayList<>())
          .add(fix(state, measuredNanos(state, logNanos)));
    }
  }

  private static Fix fix(StateInformation state, long nanos) {
    Point at = global(state.referenceFrame(), state.x(), state.y());
    return new Fix(nanos, longitude(at.x()), at.y(), state.z());
  }

  private static Point global(ReferenceFrame frame, OptionalDouble x, OptionalDouble y) {
    return UtmGrid.global(frame, Point.of(x.getAsDouble(), y.getAsDouble(), 0.0));
  }

  /** Wraps into -180…180: a message may contain 180.5 instead of -179.5. */
  private static double longitude(double degrees) {
    return Math.abs(degrees) > TURN_DEG / 2.0 ? Math.IEEEremainder(degrees, TURN_DEG) : degrees;
  }

  private static long measuredNanos(U2SAData message, long logNanos) {
    return message.timestamp().isPresent()
        ? Math.round(message.timestamp().getAsLong() * NANOS_PER_MICRO)
        : logNanos;
  }

  private void take(GoalInformation goal) {
    if (goal instanceof Waypoint waypoint
        && waypoint.referenceFrame().isEarth()
        && waypoint.x().isPresent()
        && waypoint.y().isPresent()) {
      Point at = global(waypoint.referenceFrame(), waypoint.x(), waypoint.y());
      goals.put(
          waypoint.uid(),
          new Goal(
              waypoint.uid(),
              longitude(at.x()),
              at.y(),
              waypoint.z(),
              waypoint.horizontalThreshold(),
              waypoint.completed() && !waypoint.abandoned()));
    }
  }

  /** Positions by track, each track in recording order. */
  public Map<String, List<Fix>> tracks() {
    return tracks;
  }

  /** Number of positions in all tracks. */
  public int points() {
    return tracks.values().stream().mapToInt(List::size).sum();
  }

  /** Goals in order of first appearance. */
  public List<Goal> goals() {
    return List.copyOf(goals.values());
  }
}
