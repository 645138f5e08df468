package org.u2sa.world.scanmap;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.grid.GridModeller;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.PoseHistory;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/**
 * Matches each scan with a map of earlier ones and publishes the pose as a measurement for the
 * State Estimator (thesis 4.3.1.2); closes loops and rebuilds the grid from the map. Scans enter
 * the grid at their matched pose, scans of other scanners relative to the last match. The motion
 * between scans is taken from local-state, which never jumps, or from the state if the estimator
 * publishes no local-state.
 */
public final class ScanMapModeller implements Modeller {
  /** Name of the measurements' source. */
  public static final String SOURCE = "ScanMap";

  private static final long LOCAL_GAP_MICROS = 500_000L;
  private static final long LOST_MICROS =
      5_000_000L; // maximum interval between scans: beyond it the map is restarted

  private final Settings<ScanMapVariables> settings;
  private final Settings<GridModeller.Variables> gridSettings;
  private final GridModeller grid;
  private final PoseHistory locals = new PoseHistory();
  private final List<StateInformation> corrections = new ArrayList<>();
  private final Function<String, Path> files;
  private final boolean saves;
  private final boolean isFirst;
  private MapFile.Contents saved; // of MAP FILE, or null
  private MapFrame frame = MapFrame.BODY;
  private ScanMap map;
  private Pose2 lastWay; // pose at the previous scan, in the axes of local-state or the state
  private boolean lastIsLocal;
  private long lastMicros;
  private String scanner = ""; // first scanner to report: only its scans are matched
  private Pose2 matched; // pose of the last matched scan, on the map
  private Pose2 matchedTold; // same, according to the state

  /**
   * @param configuration configuration of the World Modeler
   * @param grid the grid to rebuild
   * @param files resolves file names in the configuration
   * @param saves whether SAVE MAP applies
   * @param isFirst whether the run begins, and with it the vehicle is at MAP START: not after a
   *     restart or swap
   */
  public ScanMapModeller(
      Configurator configuration,
      GridModeller grid,
      Function<String, Path> files,
      boolean saves,
      boolean isFirst) {
    this.isFirst = isFirst;
    this.files = files;
    this.saves = saves;
    settings = configuration.settings(ScanMapVariables.class);
    gridSettings = configuration.settings(GridModeller.Variables.class);
    this.grid = grid;
  }

  @Override
  public void local(StateInformation state) {
    locals.add(state);
  }

  @Override
  public void scan(RangeScan scan, ScanPoses poses) {
    scanner = scanner.isEmpty() ? scan.sensorName() : scanner;
    Optional<StateInformation> vehicle = poses.first().vehicle();
    if (vehicle.isEmpty()) {
      tellStart(poses.first().micros());
      grid.scan(scan, poses);
      return;
    }
    PlanarFrame plane = new PlanarFrame(frame);
    Pose2 told = plane.pose(vehicle.get());
    if (!scan.sensorName().equals(scanner)) {
      enter(scan, poses, plane, map == null ? told : matched.times(told.from(matchedTold)));
      return;
    }
    ScanPoints points = points(scan, poses, told);
    Pose2 step = step(plane, told, poses.first().micros());
    if (map == null) {
      begin(plane, told, vehicle.get());
    } else if (map.isLost() && !isStartTold() && hasSigma(vehicle.get())) {
      map.expect(told, PlanarFrame.covariance(vehicle.get()));
      step = Pose2.ORIGIN;
    }
    ScanMap.Located located = map.locate(points, scan, step);
    if (located.isRebuilt()) {
      rebuild(plane, vehicle.get());
    }
    matched = located.pose();
    matchedTold = told;
    enter(scan, poses, plane, matched);
    if (located.isMatched() && settings.get().correctState()) {
      double z = frame.vehicle(vehicle).z();
      StateInformation measured = plane.measurement(located.pose(), located.covariance(), z);
      measured.sensorName(SOURCE).timestamp(poses.first().micros());
      corrections.add(measured);
    }
  }

  private ScanPoints points(RangeScan scan, ScanPoses poses, Pose2 told) {
    ScanMapVariables now = settings.get();
    return ScanPoints.of(
        scan,
        poses,
        told,
        gridSettings.get().band(),
        frame.up(),
        now.matchReach(),
        now.matchPoints());
  }

  /** Motion since the previous scan, in the vehicle's axes at that scan. */
  private Pose2 step(PlanarFrame plane, Pose2 told, long micros) {
    Optional<StateInformation> local = locals.at(micros, LOCAL_GAP_MICROS);
    Pose2 way = local.map(plane::local).orElse(told);
    boolean joins = lastWay != null && lastIsLocal == local.isPresent();
    Pose2 step = joins ? way.from(lastWay) : Pose2.ORIGIN;
    lastWay = way;
    lastIsLocal = local.isPresent();
    lastMicros = micros;
    return step;
  }

  private void begin(PlanarFrame plane, Pose2 told, StateInformation vehicle) {
    ScanMapVariables now = settings.get();
    double[] start = now.start();
    boolean isTold = isStartTold();
    double sigma = now.mapStartSigma();
    map =
        new ScanMap(
            now,
            isTold ? plane.ofNed(start[0], start[1], start[2]) : told,
            isTold
                ? Matrix3.ofSigmas(sigma, sigma, Math.toRadians(now.mapStartPsiSigma()))
                : PlanarFrame.covariance(vehicle),
            saved(plane, vehicle));
    if (saved != null && !map.isLost()) {
      rebuild(plane, vehicle);
    }
  }

  private static boolean hasSigma(StateInformation vehicle) {
    return vehicle.number(StateField.X_SIGMA).isPresent();
  }

  private boolean isStartTold() {
    return isFirst && settings.get().start().length > 0 && frame.frame().isLocal();
  }

  /** Key scans of MAP FILE, at their poses in this map. */
  private List<KeyScan> saved(PlanarFrame plane, StateInformation vehicle) {
    if (saved == null) {
      return List.of();
    }
    MapFrame other = saved.frame();
    if (!other.frame().equals(frame.frame())) {
      throw new BadInputException(
          settings.get().mapFile() + " is in " + other.frame() + ", the state in " + frame.frame());
    }
    List<KeyScan> keys = new ArrayList<>();
    for (MapFile.Saved each : saved.scans()) {
      Point place =
          Point.of(each.pose().x(), each.pose().y(), frame.vehicle(Optional.of(vehicle)).z());
      Point here = frame.metres(other.point(place));
      Pose2 pose = new Pose2(here.x(), here.y(), each.pose().theta());
      Sighting sighting = new Sighting(lastMicros, frame, Optional.of(plane.moved(vehicle, pose)));
      ScanPoses still = ScanPoses.still(sighting);
      keys.add(new KeyScan(pose, points(each.scan(), still, pose), each.scan(), 0.0));
    }
    return keys;
  }

  @Override
  public void end() {
    String file = settings.get().saveMap();
    if (!saves || file.isEmpty() || map == null || saved != null) {
      return;
    }
    try {
      MapFile.write(files.apply(file), frame, map.keys());
    } catch (IOException e) {
      throw new UncheckedIOException("cannot save the map: " + e.getMessage(), e);
    }
  }

  private void tellStart(long micros) {
    double[] start = settings.get().start();
    if (start.length == 0 || !isFirst) {
      return;
    }
    double sigma = settings.get().mapStartSigma();
    StateInformation measured =
        new StateInformation()
            .sensorName(SOURCE)
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(start[0])
            .y(start[1])
            .psi(start[2]);
    measured
        .xSigma(sigma)
        .ySigma(sigma)
        .psiSigma(Math.toRadians(settings.get().mapStartPsiSigma()))
        .timestamp(micros);
    corrections.add(measured);
  }

  /** Enters a scan into the grid at its pose on the map. */
  private void enter(RangeScan scan, ScanPoses poses, PlanarFrame plane, Pose2 pose) {
    Sighting first = poses.first();
    StateInformation vehicle = first.vehicle().orElseThrow();
    Sighting placed = new Sighting(first.micros(), frame, Optional.of(plane.moved(vehicle, pose)));
    Optional<StateInformation> last =
        poses
            .last()
            .map(end -> plane.moved(end, pose.times(plane.pose(end).from(plane.pose(vehicle)))));
    grid.scan(scan, new ScanPoses(placed, last));
  }

  private void rebuild(PlanarFrame plane, StateInformation vehicle) {
    Sighting now = new Sighting(lastMicros, frame, Optional.of(vehicle));
    grid.enter(frame, now);
    for (KeyScan key : map.keys()) {
      Sighting placed =
          new Sighting(lastMicros, frame, Optional.of(plane.moved(vehicle, key.pose())));
      grid.scan(key.scan(), ScanPoses.still(placed));
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
    String file = settings.get().mapFile();
    saved = file.isEmpty() ? null : saved == null ? MapFile.read(files.apply(file)) : saved;
    frame = newFrame;
    map = null;
    lastWay = null;
    grid.enter(newFrame, now);
  }

  @Override
  public Optional<OccupancyGrid> grid(Sighting now) {
    return grid.grid(now);
  }

  /** Key scans of the map, in the map's axes; empty before the first. */
  List<KeyScan> keys() {
    return map == null ? List.of() : map.keys();
  }

  @Override
  public String remark() {
    return map == null ? "no map yet" : map.toString();
  }
}
