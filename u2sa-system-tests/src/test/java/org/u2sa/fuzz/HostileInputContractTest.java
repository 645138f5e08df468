package org.u2sa.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.u2sa.control.cascade.AllocatingControl;
import org.u2sa.control.fixedwing.CessnaControl;
import org.u2sa.control.ground.AckermannPursuitControl;
import org.u2sa.control.ground.DifferentialDriveControl;
import org.u2sa.control.ground.DifferentialPursuitControl;
import org.u2sa.core.health.HealthMonitor;
import org.u2sa.core.safety.SafetyManager;
import org.u2sa.estimation.ComplementaryStateEstimator;
import org.u2sa.estimation.FusingStateEstimator;
import org.u2sa.estimation.PassThroughStateEstimator;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.mission.MissionManager;
import org.u2sa.planning.PathPlanner;
import org.u2sa.recorder.Recorder;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;
import org.u2sa.testkit.ServiceKit;
import org.u2sa.world.WorldModeler;

/**
 * Whatever a reader lets through, in any order of types: a standard service handles it without an
 * exception, still runs, and publishes nothing that the wire does not take.
 */
class HostileInputContractTest {
  private static final long SEED = 4;
  private static final int MIXED = 600;
  private static final Map<String, Function<ServiceContext, U2SAService>> SERVICES =
      new LinkedHashMap<>();

  static {
    SERVICES.put("SafetyManager", SafetyManager::new);
    SERVICES.put("HealthMonitor", HealthMonitor::new);
    SERVICES.put("MissionManager", MissionManager::new);
    SERVICES.put("PathPlanner", PathPlanner::new);
    SERVICES.put("WorldModeler", WorldModeler::new);
    SERVICES.put("FusingStateEstimator", FusingStateEstimator::new);
    SERVICES.put("ComplementaryStateEstimator", ComplementaryStateEstimator::new);
    SERVICES.put("PassThroughStateEstimator", PassThroughStateEstimator::new);
    SERVICES.put("CessnaControl", CessnaControl::new);
    SERVICES.put("AllocatingControl", AllocatingControl::new);
    SERVICES.put("AckermannPursuitControl", AckermannPursuitControl::new);
    SERVICES.put("DifferentialPursuitControl", DifferentialPursuitControl::new);
    SERVICES.put("DifferentialDriveControl", DifferentialDriveControl::new);
    SERVICES.put("Recorder", Recorder::new);
  }

  @TestFactory
  @Timeout(300)
  Stream<DynamicTest> handle_extremeMessages_neitherFailsNorThrows() {
    return attacks(ExtremeMessages::all);
  }

  @TestFactory
  @Timeout(300)
  Stream<DynamicTest> handle_mixedMessagesThriceEach_neitherFailsNorThrows() {
    return attacks(extreme -> extreme.mixed(new Random(SEED), MIXED));
  }

  private static Stream<DynamicTest> attacks(Function<ExtremeMessages, List<U2SAData>> messages) {
    return SERVICES.keySet().stream()
        .map(name -> DynamicTest.dynamicTest(name, () -> attack(name, messages)));
  }

  private static void attack(String name, Function<ExtremeMessages, List<U2SAData>> messages) {
    try (ServiceKit kit = new ServiceKit()) {
      if (name.equals("MissionManager")) {
        kit.with("MISSION", Path.of("../missions/ugv/loop.xml").toAbsolutePath().toString())
            .with("DEFAULT THRESHOLD", 1.0);
      }
      if (name.equals("WorldModeler")) {
        kit.with("MODELLERS", "OBJECTS, GRID").with("USUAL SPEED", 1.0).with("CONFIRM HITS", 1);
      }
      U2SAService service = kit.start(SERVICES.get(name));
      kit.advance(1.0);
      for (U2SAData message : messages.apply(new ExtremeMessages(service.getServiceName()))) {
        if (!(message instanceof StopCommand)) {
          received(kit, message).ifPresent(each -> publish(kit, each));
        }
      }
      kit.advance(1.0);

      assertThat(service.status())
          .as(() -> String.join("\n", kit.log(service.getServiceName())))
          .isEqualTo(ServiceStatus.RUNNING);
      HealthReport report =
          kit.published(Channels.HEALTH).stream()
              .filter(each -> each.serviceName().equals(service.getServiceName()))
              .filter(each -> each.published().isPresent())
              .reduce((one, other) -> other)
              .orElseThrow();
      assertThat(report.exceptions())
          .as(() -> String.join("\n", kit.log(service.getServiceName())))
          .isZero();
      for (Channel<?> channel : service.publishedChannels()) {
        kit.published(channel).forEach(message -> assertThat(message.serialize()).isNotEmpty());
      }
    }
  }

  /** What a service receives; empty if a reader refuses it, as combinations at random may be. */
  private static Optional<U2SAData> received(ServiceKit kit, U2SAData message) {
    MessageCodec codec = new MessageCodec(StandardTypes.registry());
    if (message.timestamp().isEmpty()) {
      message.timestamp(kit.clock().micros());
    }
    try {
      return Optional.of(codec.decode(message.typeChain(), codec.encode(message)));
    } catch (MalformedMessageException e) {
      return Optional.empty();
    }
  }

  @SuppressWarnings("unchecked") // the channel carries it
  private static void publish(ServiceKit kit, U2SAData message) {
    List<Channel<?>> carriers =
        Channels.all().stream().filter(channel -> channel.carries(message)).toList();
    for (Channel<?> channel : carriers) {
      kit.publish((Channel<U2SAData>) channel, message);
      kit.advance(0.05);
    }
  }
}
