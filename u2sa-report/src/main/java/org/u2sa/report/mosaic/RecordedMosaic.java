package org.u2sa.report.mosaic;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.recorder.playback.RecordedSpan;

/** Makes the mosaic of a recording: its search areas or, if it has none, everything seen. */
public final class RecordedMosaic {
  private static final double MARGIN_M = 10.0;
  private static final int MAX_TRIED = 30;

  private final Set<Geodetic> areas = new LinkedHashSet<>(); // corners
  private final Set<Geodetic> footprints = new LinkedHashSet<>();

  private RecordedMosaic() {}

  /**
   * Makes the mosaic.
   *
   * @param file for messages
   * @param pixelM side of a pixel on the ground
   * @throws BadInputException if no images with footprints were recorded, or the mosaic is too
   *     large
   */
  public static SurveyMosaic of(
      Path file, RecordedMessages recording, RecordedSpan span, double pixelM) throws IOException {
    RecordedMosaic ground = new RecordedMosaic();
    recording.forEach(
        on(recording, Channels.GOALS.name(), Channels.SENSED_OBJECTS.name()),
        span,
        (topic, message, nanos) -> ground.take(message));
    if (ground.footprints.isEmpty()) {
      throw new BadInputException(
          file + ": contains no image footprints; expected those of a SurveyCamera");
    }
    SurveyMosaic mosaic =
        new SurveyMosaic(
            MosaicGrid.around(
                ground.areas.isEmpty() ? near(ground.footprints) : ground.areas, pixelM, MARGIN_M));
    recording.forEach(
        on(recording, Channels.IMAGES.name(), Channels.SENSED_OBJECTS.name()),
        span,
        (topic, message, nanos) -> mosaic.take(message));
    if (mosaic.used() == 0) {
      throw new BadInputException(
          file
              + ": contains no image with a footprint; expected those of a SurveyCamera with IMAGE EVERY above 0");
    }
    return mosaic;
  }

  /**
   * Positions that one mosaic can show: if some are too far away, such as after a wrong fix, only
   * those around the one that has most others near it.
   */
  static Collection<Geodetic> near(Collection<Geodetic> places) {
    List<Geodetic> all = List.copyOf(places);
    if (around(all.get(0), all, MosaicGrid.MAX_SPAN_M).size() == all.size()) {
      return all;
    }
    double nearM = 0.5 * MosaicGrid.MAX_SPAN_M - 2.0 * MARGIN_M; // fits in every direction
    List<Geodetic> most = List.of();
    int step = 1 + all.size() / MAX_TRIED;
    for (int i = 0; i < all.size(); i += step) {
      List<Geodetic> near = around(all.get(i), all, nearM);
      most = near.size() > most.size() ? near : most;
    }
    return most;
  }

  private static List<Geodetic> around(Geodetic middle, List<Geodetic> places, double withinM) {
    return places.stream().filter(place -> middle.distanceM(place) <= withinM).toList();
  }

  private static Predicate<McapChannel> on(RecordedMessages recording, String... channels) {
    Set<String> names = Set.of(channels);
    return channel ->
        recording.topic(channel).filter(topic -> names.contains(topic.channel())).isPresent();
  }

  private void take(U2SAData message) {
    if (message instanceof GoalList list) {
      list.goals().stream()
          .filter(SearchArea.class::isInstance)
          .map(SearchArea.class::cast)
          .filter(area -> area.referenceFrame().equals(ReferenceFrame.GLOBAL))
          .forEach(area -> add(area.corners(), areas));
    } else if (message instanceof ImageFootprint shown && SurveyMosaic.isUsable(shown)) {
      add(shown.points(), footprints);
    }
  }

  private static void add(List<Point> points, Set<Geodetic> to) {
    points.forEach(point -> to.add(Geodetic.of(point)));
  }
}
