package org.u2sa.report.summary;

import java.awt.Graphics2D;
import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.report.ReportFile;
import org.u2sa.report.export.TrackCsv;
import org.u2sa.report.export.TrackKml;
import org.u2sa.report.picture.PictureFile;
import org.u2sa.report.picture.TrackPicture;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.RunScorer;
import org.u2sa.report.score.Track;
import org.u2sa.report.score.TrackSample;

/**
 * Results of a finished run, and the files that contain them: {@code track.csv}, {@code track.kml},
 * {@code track.svg}, {@code track.png} and {@code summary.json}.
 *
 * <p>Each file is complete or absent, and {@code summary.json} is written last: a directory that
 * contains it is complete.
 *
 * @param facts facts about the run
 * @param plan plan of the run
 * @param track ground-truth track, oldest first
 * @param score score, see {@link RunScorer}
 */
public record RunReport(RunDetails facts, RunPlan plan, List<TrackSample> track, RunScore score) {

  /** Name of the machine-readable file. */
  public static final String SUMMARY = "summary.json";

  public RunReport {
    track = List.copyOf(track);
  }

  /** Scores a run and creates its report. */
  public static RunReport of(RunDetails facts, RunPlan plan, Track track, RunOutcome outcome) {
    return new RunReport(
        facts, plan, track.samples(), RunScorer.score(plan, track.samples(), outcome));
  }

  /**
   * Creates the directory of a run before it starts, so that an invalid {@code --out} fails early.
   *
   * @throws BadInputException if it cannot be created or written to
   */
  public static void prepare(Path directory) {
    try {
      Files.createDirectories(directory);
      Files.delete(Files.createTempFile(directory, ".writable", ".part"));
    } catch (IOException e) {
      throw new BadInputException("cannot write to " + directory + ": " + ReportFile.reason(e), e);
    }
  }

  /**
   * Deletes an earlier run's summary at the start of the next, since the directory is no longer
   * complete.
   *
   * @throws BadInputException if it cannot be deleted
   */
  public static void deleteSummary(Path directory) {
    try {
      Files.deleteIfExists(directory.resolve(SUMMARY));
    } catch (IOException e) {
      throw new BadInputException("cannot write to " + directory + ": " + ReportFile.reason(e), e);
    }
  }

  /**
   * Writes all files into {@code directory}, creating it if necessary.
   *
   * @return empty, or the reason why {@code track.svg} and {@code track.png} are missing: a Java
   *     without fonts cannot draw, which must not lose the run
   * @throws RunFailedException naming the file and the cause if a file cannot be written; {@code
   *     summary.json} is then missing
   */
  public Optional<String> write(Path directory) {
    try {
      Files.createDirectories(directory);
      Files.deleteIfExists(directory.resolve(SUMMARY));
    } catch (IOException e) {
      throw new RunFailedException("cannot write to " + directory + ": " + ReportFile.reason(e), e);
    }
    String title = TrackPicture.title(facts, score);
    ReportFile.writeText(
        directory.resolve("track.csv"), out -> TrackCsv.write(out, plan.domain(), track));
    ReportFile.writeText(
        directory.resolve("track.kml"), out -> TrackKml.write(out, title, plan, score, track));
    Optional<String> obstacle = PictureFile.obstacle();
    if (obstacle.isEmpty()) {
      ReportFile.writeText(
          directory.resolve("track.svg"),
          out -> PictureFile.svg(out, title, TrackPicture.WIDTH, TrackPicture.HEIGHT, this::draw));
      ReportFile.write(
          directory.resolve("track.png"),
          out -> PictureFile.png(out, TrackPicture.WIDTH, TrackPicture.HEIGHT, this::draw));
    }
    writeSummary(directory);
    return obstacle.map(reason -> "no track.svg and track.png: " + reason);
  }

  /**
   * Writes only {@code summary.json} into the existing {@code directory}.
   *
   * @throws RunFailedException naming the file and the system's reason if it cannot be written
   */
  public void writeSummary(Path directory) {
    ReportFile.writeText(directory.resolve(SUMMARY), this::writeSummary);
  }

  private void draw(Graphics2D graphics) {
    TrackPicture.draw(graphics, facts, plan, score, track);
  }

  /** Writes the content of {@code summary.json} for {@code --json}; does not close {@code out}. */
  public void writeSummary(Writer out) throws IOException {
    out.write(SummaryJson.text(plan.domain(), facts, score));
    out.flush();
  }
}
