package org.u2sa.service.directory;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.testkit.ServiceKit;

@Timeout(120)
class ServiceDirectoryTest {
  private static final Channel<PercentageCommand> RUDDER =
      Channel.latest("rudder", PercentageCommand.TYPE, ActuatorCommand::actuatorName);

  @AutoClose private final ServiceKit kit = new ServiceKit();

  private final ServiceDirectory directory =
      new ServiceDirectory(kit.clock(), (channel, request) -> {});

  /** Looks for states, whoever has them: the example of the class's documentation. */
  private static final class Seeker extends PeriodicService {
    private final ServiceDirectory directory = new ServiceDirectory(clock(), this::publish);

    Seeker(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Seeker", 2.0);
      ServiceDirectory.CHANNELS.forEach(this::registerSubscriber);
    }

    @Override
    public void callback(U2SAData data) {
      directory.take(data);
    }

    @Override
    protected void step(double nowS) {
      directory.refresh();
    }
  }

  /** Offers states of itself, and takes commands. */
  private static final class Compass extends PeriodicService {
    Compass(ServiceContext context) {
      super(context, ServiceRole.PROPRIOCEPTIVE_SENSOR, "Compass", 1.0);
      registerPublisher(Channels.SENSED_STATE);
      registerPublisher(RUDDER);
      registerSubscriber(Channels.ACTUATION);
    }

    @Override
    protected void step(double nowS) {
      publish(new StateInformation().sensorName("compass").x(1.0));
    }
  }

  private ServiceDirectory seek() {
    ServiceDirectory directory = kit.start(Seeker::new).directory;
    kit.advance(2.0);
    return directory;
  }

  private static List<String> names(List<ServiceDirectory.Found> found) {
    return found.stream()
        .map(each -> each.service().name() + " " + each.offer() + (each.certain() ? "" : " ?"))
        .toList();
  }

  @Test
  void publishersOf_typeOfAChannel_findsTheServiceThatNobodyNamed() {
    kit.start(Compass::new);
    ServiceDirectory directory = seek();

    assertThat(names(directory.publishersOf(StateInformation.TYPE)))
        .containsExactly("Compass sensed-state/StateInformation");
    assertThat(directory.service("Compass").orElseThrow().discovery().orElseThrow().serviceType())
        .isEqualTo("PROPRIOCEPTIVE_SENSOR");
  }

  @Test
  void publishersOf_baseType_findsThoseOfItsSubclasses() {
    kit.start(Compass::new);

    assertThat(names(seek().publishersOf(ActuatorCommand.TYPE)))
        .containsExactly("Compass rudder/ActuatorCommand/PercentageCommand");
  }

  @Test
  void publishersOf_subclassOfAChannelsType_isPossibleNotCertain() {
    kit.start(Compass::new);

    assertThat(names(seek().publishersOf(List.of("StateInformation", "AircraftState"))))
        .containsExactly("Compass sensed-state/StateInformation ?");
  }

  @Test
  void subscribersOf_subclass_findsWhoTakesItsAncestor() {
    kit.start(Compass::new);

    assertThat(names(seek().subscribersOf(PercentageCommand.TYPE)))
        .containsExactly("Compass actuation/ActuatorCommand ?");
  }

  @Test
  void publishersOf_channelOfAnyMessage_countsForNothing() {
    ServiceDirectory directory = seek();

    directory.take(functionality("Anybody", "discovery/"));

    assertThat(directory.publishersOf(StateInformation.TYPE)).isEmpty();
    assertThat(directory.publishersOf(List.of())).isEmpty();
  }

  @Test
  void take_serviceStartsLater_isAskedAndFound() {
    ServiceDirectory directory = seek();
    assertThat(directory.publishersOf(StateInformation.TYPE)).isEmpty();

    kit.start(Compass::new);
    kit.advance(2.0);

    assertThat(directory.publishersOf(StateInformation.TYPE)).hasSize(1);
  }

  @Test
  void take_serviceEnds_isForgottenAtOnce() {
    Compass compass = kit.start(Compass::new);
    ServiceDirectory directory = seek();

    compass.kill();
    kit.settle();

    assertThat(directory.service("Compass")).isEmpty();
    assertThat(directory.publishersOf(StateInformation.TYPE)).isEmpty();
  }

  private static HealthReport health(String instance, ServiceStatus status) {
    return new HealthReport().serviceName("Far").status(status).instance(instance);
  }

  private static FunctionalityResponse functionality(String service, String publishes) {
    return new FunctionalityResponse().serviceName(service).publishes(List.of(publishes));
  }

  @Test
  void refresh_silentForLongerThanTheLimit_isForgotten() {
    directory.take(health("1", ServiceStatus.RUNNING));
    kit.advance(ServiceDirectory.LOST_AFTER_S);
    directory.refresh();
    assertThat(directory.service("Far")).isPresent();

    kit.advance(0.1);
    directory.refresh();

    assertThat(directory.service("Far")).isEmpty();
  }

  @Test
  void refresh_reportsAreRare_waitsForThreeOfThem() {
    directory.take(health("1", ServiceStatus.RUNNING).interval(10.0));

    kit.advance(29.0);
    directory.refresh();

    assertThat(directory.service("Far")).isPresent();
  }

  @Test
  void take_lastWordOfAnEarlierInstance_keepsTheNewOne() {
    directory.take(health("1", ServiceStatus.RUNNING));
    directory.take(functionality("Far", "state/StateInformation"));
    directory.take(health("2", ServiceStatus.RUNNING));

    directory.take(
        new ConnectionLost().serviceName("Far").status(ServiceStatus.FAILED).instance("1"));

    KnownService far = directory.service("Far").orElseThrow();
    assertThat(far.instance()).contains("2");
    assertThat(far.publishes()).as("what the earlier one offered").isEmpty();
  }

  @Test
  void take_connectionLostOfTheKnownInstance_forgetsIt() {
    directory.take(health("1", ServiceStatus.RUNNING));

    directory.take(
        new ConnectionLost().serviceName("Far").status(ServiceStatus.FAILED).instance("1"));

    assertThat(directory.services()).isEmpty();
  }

  @Test
  void take_conditionOfAKnownService_isKept() {
    ServiceCondition condition =
        new ServiceCondition().serviceName("Far").condition(Condition.STALLED);
    directory.take(condition);
    assertThat(directory.services()).as("a condition alone makes no service").isEmpty();

    directory.take(
        new DiscoveryResponse().serviceName("Far").status(ServiceStatus.RUNNING).instance("1"));
    directory.take(condition);

    assertThat(directory.service("Far").orElseThrow().condition()).contains(condition);
  }

  @Test
  void take_whatItHasNoUseFor_isLeftToTheCaller() {

    assertThat(directory.take(new StateInformation().sensorName("a").x(1.0))).isFalse();
  }
}
