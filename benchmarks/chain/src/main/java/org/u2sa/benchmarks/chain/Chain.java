package org.u2sa.benchmarks.chain;

import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.ToLongFunction;
import org.HdrHistogram.Histogram;
import org.HdrHistogram.SynchronizedHistogram;
import org.u2sa.control.ground.DifferentialPursuitControl;
import org.u2sa.estimation.FusingStateEstimator;
import org.u2sa.planning.PathPlanner;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.Recorder;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/**
 * Sensors, State Estimator, Path Planner, Control and two motors of the ground vehicle on the direct path in real time,
 * configured as config/ugv has them, and what runs beside them.
 */
final class Chain {
  static final String SYSTEM = "chain";

  private static final long LONGEST_NANOS = 60_000_000_000L;
  private static final int DIGITS = 3;
  private static final double NANOS_PER_S = 1e9;
  /** The estimator's OUTPUT RATE [Hz]: above the IMU's, so that each of its measurements gives a state at once. */
  private static final double OUTPUT_HZ = 1000.0;

  private final Scenario scenario;
  private final Transport transport;
  private final Path config;
  private final Map<String, Object> forAll; // variables of each service
  private final Path logs = Files.createTempDirectory("u2sa-benchmark");
  private final SystemClock clock = new SystemClock();
  private final Causes causes = new Causes();
  private final List<U2SAService> services = new ArrayList<>();
  private final Histogram command = new SynchronizedHistogram(LONGEST_NANOS, DIGITS);
  private final Histogram plan = new SynchronizedHistogram(LONGEST_NANOS, DIGITS);
  private final long periodNanos;
  private volatile long fromNanos = Long.MAX_VALUE; // measured are those sent from here …
  private volatile long toNanos = Long.MAX_VALUE; // … to here
  private long commanded; // under command
  private long lateOnes; // likewise

  Chain(Scenario scenario, Transport transport, Path config, Map<String, Object> forAll) throws Exception {
    this.scenario = scenario;
    this.transport = transport;
    this.config = config;
    this.forAll = forAll;
    periodNanos = (long) (NANOS_PER_S / scenario.hz());
  }

  ChainResult run(double warmUpS, double seconds, int round) throws Exception {
    HealthWatch health = started(new HealthWatch(context(XmlConfiguration.inMemory("HealthWatch", Map.of()))));
    if (scenario.company().equals("recorder")) {
      started(new Recorder(context(XmlConfiguration.inMemory("Recorder", Map.of()))));
    }
    for (String name : List.of("LEFT MOTOR", "RIGHT MOTOR")) {
      boolean isLast = name.startsWith("RIGHT");
      XmlConfiguration named = XmlConfiguration.inMemory(name, Map.of("SERVICE NAME", name));
      started(new Motor(context(named), trace(), isLast ? this::moved : sent -> {}));
    }
    started(new DifferentialPursuitControl(context(file("Control.xml")).with(trace())));
    started(new PathPlanner(context(file("PathPlanner.xml")).with(trace())));
    XmlConfiguration estimator = file("StateEstimator.xml");
    estimator.override("OUTPUT RATE", OUTPUT_HZ);
    started(new FusingStateEstimator(context(estimator).with(trace())));
    if (scenario.company().equals("slow")) {
      started(new Slow(context(XmlConfiguration.inMemory("Slow", Map.of()))));
    }
    for (int i = 0; i < scenario.neighbours(); i++) {
      started(new Neighbour(context(XmlConfiguration.inMemory("Neighbour", Map.of())), i, scenario.neighbours()));
    }
    Sensors sensors = new Sensors(context(XmlConfiguration.inMemory("Sensors", Map.of())), scenario.hz(), causes);
    started(sensors);
    try (Connection operator = transport.connect("Operator", new Deaf())) {
      publishGoal(operator);
      Thread.sleep((long) (warmUpS * 1e3));
      System.gc(); // so that each run begins alike
      Thread.sleep(300);
      return measured(health, sensors, seconds, round);
    } finally {
      Collections.reverse(services); // those that cause messages first
      services.forEach(U2SAService::kill);
    }
  }

  private ChainResult measured(HealthWatch health, Sensors sensors, double seconds, int round) throws Exception {
    long overruns = health.sum(HealthReport::overruns);
    long dropped = health.sum(HealthReport::dropped);
    long replaced = health.sum(report -> report.replaced().orElse(0L));
    long gcCount = gc(GarbageCollectorMXBean::getCollectionCount);
    long gcMillis = gc(GarbageCollectorMXBean::getCollectionTime);
    long sentBefore = sensors.sent();
    fromNanos = System.nanoTime();
    Thread.sleep((long) (seconds * 1e3));
    toNanos = System.nanoTime();
    long sent = sensors.sent() - sentBefore;
    gcCount = gc(GarbageCollectorMXBean::getCollectionCount) - gcCount;
    gcMillis = gc(GarbageCollectorMXBean::getCollectionTime) - gcMillis;
    Thread.sleep(600); // the last of them arrive, and two health reports of each service
    long late;
    long merged;
    synchronized (command) {
      late = lateOnes;
      merged = Math.max(0, sent - commanded);
    }
    return new ChainResult(
        scenario,
        round,
        command,
        plan,
        sent,
        late,
        merged,
        health.sum(HealthReport::overruns) - overruns,
        health.sum(HealthReport::dropped) - dropped,
        health.sum(report -> report.replaced().orElse(0L)) - replaced,
        gcCount,
        gcMillis,
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
  }

  private static long gc(ToLongFunction<GarbageCollectorMXBean> figure) {
    return ManagementFactory.getGarbageCollectorMXBeans().stream().mapToLong(figure).sum();
  }

  private boolean isMeasured(long sentNanos) {
    return sentNanos >= fromNanos && sentNanos < toNanos;
  }

  private void moved(long sentNanos) {
    long took = System.nanoTime() - sentNanos;
    if (isMeasured(sentNanos)) {
      synchronized (command) {
        command.recordValueWithExpectedInterval(Math.min(took, LONGEST_NANOS), periodNanos);
        commanded++;
        if (took > periodNanos) {
          lateOnes++;
        }
      }
    }
  }

  private void planned(long sentNanos) {
    long took = System.nanoTime() - sentNanos;
    if (isMeasured(sentNanos)) {
      plan.recordValueWithExpectedInterval(Math.min(took, LONGEST_NANOS), periodNanos);
    }
  }

  private Traced trace() {
    return new Traced(causes, this::planned);
  }

  private XmlConfiguration file(String name) {
    return XmlConfiguration.load(config.resolve(name));
  }

  private ServiceContext context(XmlConfiguration configuration) {
    forAll.forEach(configuration::override);
    return ServiceContext.of(SYSTEM, configuration)
        .clock(clock)
        .transport(transport)
        .logDirectory(logs)
        .build();
  }

  private <S extends U2SAService> S started(S service) {
    services.add(service);
    service.start();
    return service;
  }

  private void publishGoal(Connection operator) {
    Waypoint north =
        new Waypoint()
            .uid("north")
            .referenceFrame(ReferenceFrame.GLOBAL)
            .x(Sensors.eastDeg())
            .y(Sensors.farNorthDeg())
            .horizontalThreshold(2.0);
    GoalList goals = new GoalList().goals(List.of(north)).upcoming(List.of());
    goals.systemId(SYSTEM);
    goals.timestamp(clock.micros());
    goals.freeze();
    operator.publish(Channels.GOALS, goals);
  }

  private static final class Deaf implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {}

    @Override
    public void trouble(String what) {
      System.err.println(what);
    }
  }
}
