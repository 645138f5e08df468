package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;
import org.u2sa.testkit.FreePort;

/**
 * Tests of an emergency stop with actuator, Safety Manager, operator and broker as on other hosts.
 */
abstract class StoppedBoat {
  private static final String SYSTEM = "boat";
  private static final Duration SOON = Duration.ofSeconds(40);

  @TempDir private Path logs;

  private final List<U2SAService> services = new ArrayList<>();
  private final AtomicInteger motors = new AtomicInteger();
  private final Map<String, Long> refused = new ConcurrentHashMap<>();
  private volatile FailsafeState failsafe = new FailsafeState().action(FailsafeAction.CONTINUE);
  private volatile boolean brokerHasStop; // since the operator has connected
  private int port;
  private CommunicationManager broker;
  private Connection operator;

  static final class Motor extends Actuator {
    private final AtomicInteger moves = new AtomicInteger();

    Motor(ServiceContext context) {
      super(context, "Motor");
    }

    @Override
    protected void actuate(double percentage) {
      moves.incrementAndGet();
    }

    @Override
    protected void neutral() {}
  }

  /** Notes how many commands each service has refused, by its own word. */
  private final class Listener implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      if (message instanceof HealthReport report) {
        refused.put(report.serviceName(), report.refused());
      } else if (message instanceof FailsafeState state) {
        failsafe = state;
      } else if (message instanceof EmergencyStop stop) {
        brokerHasStop |= stop.active();
      }
    }

    @Override
    public void trouble(String what) {}
  }

  @BeforeEach
  void start() throws IOException {
    port = FreePort.find();
    startBroker();
    connectOperator();
  }

  private void connectOperator() {
    operator = transport().connect("Operator", new Listener());
    operator.subscribe(Channels.HEALTH);
    operator.subscribe(Channels.FAILSAFE);
    operator.subscribe(Channels.EMERGENCY_STOP);
  }

  /** The broker forgets what it retained, who said it is gone, and yet it is said again. */
  void startBrokerAnewWithoutTheOperator() {
    operator.close();
    broker.close();
    startBroker();
    brokerHasStop = false;
    connectOperator();
    await().atMost(SOON).until(() -> brokerHasStop);
  }

  @AfterEach
  void end() {
    services.forEach(U2SAService::kill);
    operator.close();
    broker.close();
  }

  private void startBroker() {
    broker =
        CommunicationManager.start(
            SYSTEM,
            XmlConfiguration.inMemory("broker", Map.of("COMMUNICATION MANAGER PORT", port)),
            StandardTypes.registry(),
            line -> {});
  }

  private MqttTransport transport() {
    return new MqttTransport("127.0.0.1", port, SYSTEM, new MessageCodec(StandardTypes.registry()));
  }

  ServiceContext context(String name, Map<String, Object> variables) {
    return ServiceContext.of(SYSTEM, XmlConfiguration.inMemory(name, variables))
        .clock(new SystemClock())
        .transport(transport())
        .logDirectory(logs)
        .build();
  }

  <S extends U2SAService> S started(S service) {
    services.add(service);
    service.start();
    return service;
  }

  Motor startMotor() {
    String name = "Motor" + motors.incrementAndGet(); // so that its reports are told apart
    return started(
        new Motor(context(name, Map.of("SERVICE NAME", name, "ACTUATOR NAME", "MOTOR"))));
  }

  void end(U2SAService service) {
    services.remove(service);
    service.kill();
  }

  private <T extends U2SAData> T send(Channel<T> channel, T message) {
    message.systemId(SYSTEM);
    message.timestamp(new SystemClock().micros());
    message.freeze();
    operator.publish(channel, message);
    return message;
  }

  private void command() {
    send(Channels.ACTUATION, PercentageCommand.of("MOTOR", 50.0));
  }

  private void awaitMoving(Motor motor) {
    int before = motor.moves.get();
    await()
        .atMost(SOON)
        .until(
            () -> {
              command();
              return motor.moves.get() > before;
            });
  }

  /** Commands until it has refused some, and shows that it obeyed none. */
  void requireStopped(Motor motor) {
    int before = motor.moves.get();
    awaitRefusals(motor);
    assertThat(motor.moves).hasValue(before);
  }

  /** Commands until it says that it has refused some more. */
  private void awaitRefusals(Motor motor) {
    long before = refused.getOrDefault(motor.getServiceName(), 0L);
    await()
        .atMost(SOON)
        .until(
            () -> {
              command();
              return refused.getOrDefault(motor.getServiceName(), 0L) > before + 2;
            });
  }

  EmergencyStop stop(Motor motor) {
    awaitMoving(motor);
    EmergencyStop stop =
        send(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).operator("Ann"));
    awaitRefusals(motor);
    return stop;
  }

  /** Until the Safety Manager has said so itself, later than that. */
  void awaitKnown(long sinceMicros) {
    await()
        .atMost(SOON)
        .until(
            () ->
                failsafe.action() == FailsafeAction.STOP
                    && failsafe.timestamp().orElseThrow() > sinceMicros);
  }

  private void clear(EmergencyStop stop) {
    send(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(false).clears(stop.timestamp().orElseThrow()).operator("Ann"));
  }

  /** Shows that it obeys nothing until the stop is cleared, and then does. */
  void requireStoppedUntilCleared(Motor again, EmergencyStop stop) {
    requireStopped(again);
    assertThat(again.moves).hasValue(0);
    clear(stop);
    awaitMoving(again);
  }
}
