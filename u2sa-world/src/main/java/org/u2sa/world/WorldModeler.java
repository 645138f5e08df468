package org.u2sa.world;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.ConfigurationException;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.handover.HandOver;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.PoseHistory;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/**
 * Maintains the world model (thesis 3.2.3.3): passes each sighting and scan, with the vehicle's
 * state at its measurement time, to the {@link Modeller}s selected by MODELLERS, and publishes
 * their results at RATE. In: sensed-objects, scans, state, goals; local-state, if a modeller
 * measures the state; sensed-state, if one needs it. Out: objects, grid; sensed-state, if a
 * modeller measures the state.
 *
 * <p>Without a vehicle state it works in BODY (thesis 4.3.2) and switches frames when a state
 * arrives.
 */
public final class WorldModeler extends PeriodicService {
  private static final int MAX_OBJECTS = 1_000; // sighted in a step
  private static final int MAX_OF_ONE = 300; // of them by one sensor
  private static final double RATE_HZ = 10.0;
  private static final int CONFIRMED_BY = 3; // measurements: the default of CONFIRM HITS
  private static final long FUTURE_MICROS = Clock.MICROS_PER_SECOND; // tolerated clock difference
  private static final double LONGEST_SCAN_S = 10.0; // longer scans are invalid

  private final ServiceContext context;
  private final Settings<WorldVariables> settings = settings(WorldVariables.class);
  private final ChosenModellers modellers;
  private final PoseHistory poses = new PoseHistory();
  private final Arrivals arrivals = new Arrivals();
  private final Relevance relevance = new Relevance();
  private final SightingCount count = new SightingCount();
  private final AwaitedSensors sensors;
  private MapFrame frame = MapFrame.BODY;
  private final KnownObjects known;
  private long heardStateMicros; // run clock, not the state's timestamp
  private boolean isMeasuring; // has registered for the needs of modellers that measure the state
  private boolean isSensing; // has subscribed to proprioceptive measurements
  private long gridDueMicros = Long.MIN_VALUE;

  public WorldModeler(ServiceContext context) {
    super(context, ServiceRole.WORLD_MODELER, "WorldModeler", RATE_HZ);
    this.context = context;
    sensors = new AwaitedSensors(context.isRestart() ? CONFIRMED_BY : 1);
    modellers =
        new ChosenModellers(
            this,
            context.configuration()::resolve,
            context.execution().writesNamedFiles(),
            !context.isRestart() && !context.isSwap());
    registerPublisher(Channels.OBJECTS);
    registerPublisher(Channels.GRID);
    known = new KnownObjects(context, settings);
    tellGap();
    choose();
    subscribe(Channels.STATE, this::onState);
    subscribe(Channels.SENSED_OBJECTS, this::onArrival);
    subscribe(Channels.SCANS, this::onArrival);
    subscribe(Channels.GOALS, this::onGoals);
  }

  private void choose() {
    List<String> names;
    try {
      names = modellers.names(settings.get().modellers());
    } catch (IllegalArgumentException e) {
      throw new ConfigurationException(e.getMessage(), e);
    }
    modellers.working().keySet().forEach(name -> remark(name, ""));
    if (ChosenModellers.measureState(names) && !isMeasuring) {
      isMeasuring = true;
      registerPublisher(Channels.SENSED_STATE);
      subscribe(Channels.LOCAL_STATE, this::onLocalState);
    }
    modellers
        .choose(names, frame, now())
        .forEach(modeller -> modeller.known(known.placed(), known.since(now())));
    if (!isSensing && working().anyMatch(Modeller::needsSensedState)) {
      isSensing = true;
      subscribe(
          Channels.SENSED_STATE, measured -> working().forEach(each -> each.sensed(measured)));
    }
  }

  private Stream<Modeller> working() {
    return modellers.working().values().stream();
  }

  @Override
  protected Optional<String> configurationRefusal(Map<String, Object> values) {
    try {
      modellers.names((String) values.get(WorldVariables.MODELLERS));
      known.check((String) values.get(WorldVariables.WORLD));
      return Optional.empty();
    } catch (IllegalArgumentException | BadInputException e) {
      return Optional.of(e.getMessage());
    }
  }

  @Override
  protected void configurationChanged(Set<String> variableNames) {
    if (variableNames.contains(WorldVariables.WORLD)
        || variableNames.contains(WorldVariables.WORLD_MOVERS)) {
      if (variableNames.contains(WorldVariables.WORLD)) {
        known.load();
        tellGap();
      } else {
        known.reload();
      }
      tellKnown(now());
    }
    if (variableNames.contains(WorldVariables.MODELLERS)) {
      choose();
    }
  }

  /** Warns of possible obstacles that the map lacks, for as long as its file is in use. */
  private void tellGap() {
    remark("WORLD", known.gap().orElse(""));
    known.gap().ifPresent(this::trouble);
  }

  private void onState(StateInformation state) {
    if (!poses.add(state)) {
      count.badStates++;
      return;
    }
    heardStateMicros = clock().micros();
    if (!frame.takes(state)) {
      enter(MapFrame.of(state));
    }
  }

  private void onLocalState(StateInformation local) {
    modellers.working().values().forEach(modeller -> modeller.local(local));
  }

  private void enter(MapFrame next) {
    log("the map continues in " + next.frame() + ", previously in " + frame.frame());
    frame = next;
    Sighting last = new Sighting(clock().micros(), next, poses.newest());
    modellers.working().values().forEach(modeller -> modeller.enter(next, last));
    tellKnown(last);
    gridDueMicros = Long.MIN_VALUE;
  }

  /** Fixes the file's vehicle-relative objects at the first state. */
  private void tellKnown(Sighting now) {
    known.place(now);
    Sighting since = known.since(now);
    modellers.working().values().forEach(modeller -> modeller.known(known.placed(), since));
  }

  private void onArrival(U2SAData measured) {
    if (measured instanceof ImageFootprint seen) {
      working().forEach(modeller -> modeller.footprint(seen));
      return;
    }
    if (measured.timestamp().isEmpty()) {
      count.untimed++;
    } else if (measured.timestamp().getAsLong() - clock().micros() > FUTURE_MICROS) {
      count.early++; // it would wait until that time
    } else {
      arrivals.add(measured);
    }
  }

  private void onGoals(GoalList goals) {
    relevance.of(goals);
    working().forEach(modeller -> modeller.goals(goals));
  }

  @Override
  protected void step(double nowS) {
    long micros = clock().micros();
    if (!frame.frame().isBody()
        && micros - heardStateMicros > Clock.micros(settings.get().stateLostAfter())) {
      log(LogLevelEnum.WARN, "state lost");
      enter(MapFrame.BODY);
    }
    // measurements newer than the newest state wait: it may become possible to interpolate
    long placeable =
        frame.frame().isBody()
            ? micros
            : Math.max(poses.newestMicros(), micros - settings.get().waitMicros());
    place(arrivals.upTo(placeable));
    for (Modeller modeller : modellers.working().values()) {
      modeller.corrections().forEach(measured -> publish(Channels.SENSED_STATE, measured));
    }
    publish(micros);
  }

  /** Dispatches measurements, grouped by sensor and time, as many as a step has time for. */
  private void place(List<U2SAData> measured) {
    List<ObjectDescription> together = new ArrayList<>();
    Map<String, Integer> placed = new HashMap<>(); // objects by sensor
    int all = 0;
    for (U2SAData each : measured) {
      if (each instanceof ObjectDescription object) {
        if (all == MAX_OBJECTS || placed.merge(object.sensorName(), 1, Integer::sum) > MAX_OF_ONE) {
          count.crowded++;
          continue;
        }
        all++;
        if (!together.isEmpty() && !isSameFrame(together.get(0), object)) {
          objects(together);
          together = new ArrayList<>();
        }
        together.add(object);
      }
    }
    if (!together.isEmpty()) {
      objects(together);
    }
    for (U2SAData each : measured) {
      if (each instanceof RangeScan scan) {
        scan(scan);
      }
    }
  }

  private static boolean isSameFrame(ObjectDescription a, ObjectDescription b) {
    return a.sensorName().equals(b.sensorName()) && a.timestamp().equals(b.timestamp());
  }

  private void objects(List<ObjectDescription> seen) {
    Optional<Sighting> sighting = sighting(seen.get(0).timestamp().orElseThrow());
    boolean needsState = seen.get(0).referenceFrame().isBody() != frame.frame().isBody();
    if (sighting.isEmpty() && needsState) {
      count.stateless++;
      return;
    }
    count.sightings++;
    long micros = seen.get(0).timestamp().orElseThrow();
    if (seen.get(0) instanceof PointCloud cloud && cloud.isScan()) {
      sensors.cloud(cloud.sensorName(), micros);
    } else {
      sensors.sighting(seen.get(0).sensorName(), micros);
    }
    List<ObjectDescription> there =
        seen.stream()
            .filter(each -> each.confidence().orElse(1.0) > 0.0) // 0: the sensor sees nothing
            .collect(Collectors.toList());
    if (there.isEmpty()) {
      return;
    }
    Sighting placed = sighting.orElse(new Sighting(micros, frame, Optional.empty()));
    modellers.working().values().forEach(modeller -> modeller.objects(there, placed));
  }

  private void scan(RangeScan scan) {
    long first = scan.timestamp().orElseThrow();
    Optional<Sighting> sighting = sighting(first);
    if (sighting.isEmpty() || !scan.referenceFrame().isBody()) {
      count.stateless++;
      return;
    }
    double spanS = scan.timeIncrement() * Math.max(0, scan.beamCount() - 1);
    if (scan.beamCount() == 0 || spanS > LONGEST_SCAN_S) {
      count.badScans++;
      return;
    }
    long span = Clock.micros(spanS);
    Optional<StateInformation> last =
        span == 0 || frame.frame().isBody()
            ? Optional.empty()
            : poses.at(first + span, settings.get().gapMicros());
    ScanPoses placed = new ScanPoses(sighting.get(), last);
    count.scans++;
    sensors.scan(scan.sensorName(), first + span);
    modellers.working().values().forEach(modeller -> modeller.scan(scan, placed));
  }

  /** Empty if the map is GLOBAL or local and the vehicle's pose at that time is unknown. */
  private Optional<Sighting> sighting(long micros) {
    if (frame.frame().isBody()) {
      return Optional.of(new Sighting(micros, frame, Optional.empty()));
    }
    try {
      return poses
          .at(micros, settings.get().gapMicros())
          .map(vehicle -> new Sighting(micros, frame, Optional.of(vehicle)));
    } catch (IllegalArgumentException e) { // speeds that overflow the coordinates
      count.badStates++;
      return Optional.empty();
    }
  }

  private Sighting now() {
    return new Sighting(
        clock().micros(), frame, frame.frame().isBody() ? Optional.empty() : poses.newest());
  }

  private void publish(long micros) {
    Sighting now = now();
    List<ObjectDescription> objects = new ArrayList<>();
    modellers.working().values().forEach(modeller -> objects.addAll(modeller.objects(now)));
    if (modellers.working().values().stream().noneMatch(Modeller::publishesKnown)) {
      objects.addAll(known.placedAt(micros));
    }
    ObjectList list =
        new ObjectList()
            .objects(
                settings.get().relevant() == WorldVariables.Relevant.ALL
                    ? objects
                    : relevance.of(objects));
    List<String> awaited = awaited(micros);
    if (!awaited.isEmpty()) {
      list.awaited(awaited);
    }
    list.timestamp(micros);
    publish(Channels.OBJECTS, list);
    if (micros >= gridDueMicros) {
      gridDueMicros = micros + Clock.micros(1.0 / settings.get().gridRate());
      for (Modeller modeller : modellers.working().values()) {
        modeller.grid(now).ifPresent(grid -> publishGrid(grid, micros));
      }
    }
    remark("PLACED", count + (arrivals.lost() == 0 ? "" : ", " + arrivals.lost() + " lost"));
    remark("AWAITED", awaited.isEmpty() ? "" : "silent: " + String.join(", ", awaited));
    modellers.working().forEach((name, modeller) -> remark(name, modeller.remark()));
  }

  private List<String> awaited(long micros) {
    WorldVariables now = settings.get();
    boolean needsScans =
        now.world().isEmpty()
            && (modellers.working().containsKey(ChosenModellers.GRID)
                || modellers.working().containsKey(ChosenModellers.SCAN_MAP));
    return sensors.silent(now.expected(), needsScans, micros, now.silentMicros());
  }

  private void publishGrid(OccupancyGrid grid, long micros) {
    grid.timestamp(micros);
    publish(Channels.GRID, grid);
  }

  @Override
  protected void release() {
    modellers.working().values().forEach(Modeller::end);
  }

  @Override
  protected void handOver(HandOver state) {
    poses.newest().ifPresent(newest -> state.message("STATE", newest));
    frame.handOver(state);
    known.handOver(state);
    state.texts("WANTED TYPES", relevance.types());
    state.texts("SCANNERS", sensors.scanners());
    state.texts("CLOUD SCANNERS", sensors.cloudScanners());
    Sighting now = now();
    modellers.working().values().forEach(modeller -> modeller.handOver(state, now));
  }

  @Override
  protected void takeOver(HandOver state) {
    state.message("STATE", StateInformation.class).ifPresent(poses::add);
    heardStateMicros = clock().micros();
    relevance.want(state.texts("WANTED TYPES"));
    state.texts("SCANNERS").forEach(scanner -> sensors.scan(scanner, clock().micros()));
    state.texts("CLOUD SCANNERS").forEach(scanner -> sensors.cloud(scanner, clock().micros()));
    frame = MapFrame.takenOver(state).orElse(frame);
    known.takeOver(state);
    Sighting now = now();
    for (Modeller modeller : modellers.working().values()) {
      modeller.known(known.placed(), known.since(now));
      modeller.enter(frame, now);
      modeller.takeOver(state, now);
    }
  }
}
