package org.u2sa.world.grid;

import java.util.Optional;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.service.handover.HandOver;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.SensorPose;
import org.u2sa.world.modeller.Sighting;

/**
 * Maintains an occupancy grid around the vehicle from range scans. If the vehicle's pose is
 * unknown, the grid covers only the latest scans.
 */
public final class GridModeller implements Modeller {
  public record Variables(
      @Variable(unit = "m", min = 0.01, max = 100, ifAbsent = 0.1)
          @Description("Edge length of a grid cell. A change clears the grid.")
          double cellSize,
      @Variable(unit = "m", min = 1, max = 40_000, ifAbsent = 60)
          @Description("Edge length of the grid around the vehicle; up to 4096 cells.")
          double gridSize,
      @Variable(min = 0, minExcluded = true, max = 6, ifAbsent = 0.85)
          @Description("Log odds that an echo adds to its cell; 0.85 is a probability of 0.7.")
          double hitLogOdds,
      @Variable(min = 0, minExcluded = true, max = 6, ifAbsent = 0.4)
          @Description(
              "Log odds that a beam subtracts from the cells it crosses; 0.4 is a probability of 0.4.")
          double missLogOdds,
      @Variable(unit = "m", ifAbsent = -0.1)
          @Description(
              "Height relative to the vehicle's reference point below which an echo counts as ground. Multirotors need less: they lean.")
          double lowest,
      @Variable(unit = "m", ifAbsent = 2)
          @Description(
              "Height above the reference point above which the vehicle passes under an echo.")
          double highest,
      @Variable(unit = "m", min = 0, ifAbsent = 1000)
          @Description(
              "Distance up to which a beam without an echo counts as free space, limited by the scanner's farthest echo so far; lower it where dark or smooth walls return no echo.")
          double freeWithoutEcho) {
    private static final int MAX_CELLS = 4096;

    public Variables {
      if (gridSize / cellSize > MAX_CELLS) {
        throw new IllegalArgumentException(
            "GRID SIZE: " + gridSize + " m are more than 4096 cells of CELL SIZE " + cellSize);
      }
      if (lowest >= highest) {
        throw new IllegalArgumentException(
            "LOWEST: " + lowest + " m is not below HIGHEST, " + highest + " m");
      }
    }

    /** The height band and range in which echoes count. */
    public ScanEntry.Band band() {
      return new ScanEntry.Band(lowest, highest, freeWithoutEcho);
    }

    int side() {
      return Math.max(1, (int) Math.round(gridSize / cellSize));
    }
  }

  private static final double MIN_LOG_ODDS = -2.0; // a probability of 0.12
  private static final double MAX_LOG_ODDS = 3.5; // a probability of 0.97

  private final Settings<Variables> settings;
  private Variables tuning; // settings of the current grid
  private GridWindow window;
  private ScanEntry entry;
  private MapFrame frame = MapFrame.BODY;
  private long scans;
  private long beams;
  private boolean fresh; // in BODY: published since the last scan, so reset next

  public GridModeller(Configurator configuration) {
    settings = configuration.settings(Variables.class);
  }

  private void prepare() {
    if (!settings.get().equals(tuning)) {
      Variables before = tuning;
      tuning = settings.get();
      boolean sameCells =
          before != null
              && before.cellSize() == tuning.cellSize()
              && before.side() == tuning.side();
      window = sameCells ? window : new GridWindow(tuning.cellSize(), tuning.side());
      entry =
          new ScanEntry(
              window,
              new LogOdds(tuning.hitLogOdds(), tuning.missLogOdds(), MIN_LOG_ODDS, MAX_LOG_ODDS));
    }
  }

  @Override
  public void scan(RangeScan scan, ScanPoses poses) {
    prepare();
    MapFrame map = poses.first().frame();
    if (map.frame().isBody()) {
      if (fresh) {
        window.clear();
        fresh = false;
      }
      window.centre(0.0, 0.0);
    } else {
      SensorPose pose = poses.at(scan, 0.0);
      window.centre(pose.vehicle().x(), pose.vehicle().y());
    }
    beams += entry.enter(scan, poses, tuning.band(), map.up());
    scans++;
  }

  @Override
  public void enter(MapFrame newFrame, Sighting now) {
    frame = newFrame;
    if (window != null) {
      window.clear(); // cells are not valid in another frame
    }
  }

  @Override
  public Optional<OccupancyGrid> grid(Sighting now) {
    if (scans == 0 && window == null) {
      return Optional.empty();
    }
    fresh = true;
    return Optional.of(window.message(frame));
  }

  @Override
  public String remark() {
    return scans + " scans of " + beams + " beams";
  }

  @Override
  public void handOver(HandOver state, Sighting now) {
    grid(now).ifPresent(grid -> state.message("GRID", grid));
  }

  @Override
  public void takeOver(HandOver state, Sighting now) {
    state
        .message("GRID", OccupancyGrid.class)
        .ifPresent(
            grid -> {
              prepare();
              boolean fits =
                  grid.resolution() == tuning.cellSize()
                      && grid.referenceFrame().equals(frame.frame())
                      && grid.anchor().equals(frame.anchor());
              if (fits) {
                window.move(
                    Math.round(grid.left() / grid.resolution()),
                    Math.round(grid.bottom() / grid.resolution()));
                window.fill(grid);
              }
            });
  }
}
