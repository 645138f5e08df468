package org.u2sa.scenarios.igvc;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.report.ReportFile;
import org.u2sa.report.picture.PictureFile;
import org.u2sa.scenarios.camera.SeenPicture;
import org.u2sa.vision.camera.CourseSight.Seen;
import org.u2sa.vision.camera.CourseVariables;
import org.u2sa.vision.camera.PictureReading;
import org.u2sa.vision.ground.AttitudeHistory;

/**
 * Periodic pictures of the vehicle's perception in {@code snapshots}: the camera image with
 * detections, its bird's-eye view, and the surroundings with grid, lines and plan. Not thread-safe,
 * except {@link #watch}.
 */
final class RunSnapshots {
  private static final double REACH_M = 9.0;
  private static final int MAP = 720; // pixels

  private final Course course;
  private final VehicleOutline outline;
  private final Path directory;
  private final double everyS;
  private final AttitudeHistory attitudes = new AttitudeHistory();
  private volatile WatchedCamera camera; // null if none, or not requested yet
  private volatile PictureReading reading;
  private Optional<OccupancyGrid> grid = Optional.empty();
  private double nextS;

  /**
   * @param everyS interval between pictures [s]; 0 for none
   */
  RunSnapshots(Course course, VehicleOutline outline, Path directory, double everyS) {
    this.course = course;
    this.outline = outline;
    this.directory = directory.resolve("snapshots");
    this.everyS = everyS;
    nextS = everyS;
  }

  /** Watches a camera, processed according to the configuration; returns the same camera. */
  WatchedCamera watch(WatchedCamera watched, XmlConfiguration configuration) {
    reading =
        new PictureReading(
            configuration.settings(CourseVariables.class).get(),
            configuration.settings(MountingPose.class).get(),
            "Snapshot",
            configuration::resolve);
    camera = watched;
    return watched;
  }

  void state(StateInformation state) {
    attitudes.add(state);
  }

  void grid(OccupancyGrid newest) {
    grid = Optional.of(newest);
  }

  /** Whether a picture is due. */
  boolean isDue(double nowS) {
    return everyS > 0.0 && nowS >= nextS;
  }

  /** Writes a picture of a moment. */
  void write(double nowS, RunFilm.Moment moment, RunFilm film) {
    nextS = nowS + everyS;
    BufferedImage map = map(moment, film);
    BufferedImage sight = sight();
    int width = Math.max(map.getWidth(), sight.getWidth());
    BufferedImage both =
        new BufferedImage(width, sight.getHeight() + map.getHeight(), BufferedImage.TYPE_INT_RGB);
    Graphics2D pen = both.createGraphics();
    pen.drawImage(sight, 0, 0, null);
    pen.drawImage(map, 0, sight.getHeight(), null);
    pen.dispose();
    directory.toFile().mkdirs(); // the next line reports a failure
    ReportFile.write(
        directory.resolve(String.format(Locale.ROOT, "%03.0f.png", nowS)),
        out -> {
          PictureFile.png(out, both);
        });
  }

  private BufferedImage map(RunFilm.Moment moment, RunFilm film) {
    CoursePainter painter = CoursePainter.around(course, outline, moment.at(), REACH_M, MAP);
    BufferedImage image = painter.course();
    grid.ifPresent(newest -> painter.grid(image, newest, film::place));
    painter.moment(image, moment, film.track());
    return image;
  }

  /** Camera view; 1 × 1 px while there is no image. */
  private BufferedImage sight() {
    Optional<CameraFrame> frame = camera == null ? Optional.empty() : camera.newest();
    if (frame.isEmpty()) {
      return new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
    }
    long micros = frame.get().measuredAtMicros();
    Seen seen = reading.read(frame.get(), attitudes.roll(micros), attitudes.pitch(micros), 0.0);
    return SeenPicture.of(reading.unpacked(frame.get()), seen, reading.sight());
  }
}
