package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationChangeResult;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.ServiceKit;

/** Thesis 3.2.2.1: what every service answers without a line in the subclass. */
@Timeout(120)
class ServiceContractTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();
  private Planner planner;

  private static final class Planner extends EventDrivenService {
    private static final VariableDeclaration<Double> GAIN =
        VariableDeclaration.number("GAIN", "").range(Range.of(0.0, 10.0)).ifAbsent(2.0);
    private final List<String> changed = new ArrayList<>();

    Planner(ServiceContext context) {
      super(context, ServiceRole.PATH_PLANNER, "Planner");
      getVariable(GAIN);
      registerSubscriber(StateInformation.class);
      registerPublisher(NavigationPoint.class);
    }

    @Override
    protected void configurationChanged(Set<String> variableNames) {
      variableNames.forEach(name -> changed.add(name + "=" + getVariable(name)));
    }
  }

  @BeforeEach
  void start() {
    planner = kit.start(Planner::new);
  }

  private <T extends U2SAData> T answer(
      Channel<U2SAData> channel, U2SAData request, Class<T> type) {
    kit.publish(channel, request);
    return type.cast(kit.latest(channel).orElseThrow());
  }

  @Test
  void discoveryRequest_isAnsweredWithNameTypeStatusHostUptimeAndVersion() {
    kit.advance(2.0);

    DiscoveryResponse response =
        answer(Channels.DISCOVERY, new DiscoveryRequest(), DiscoveryResponse.class);

    assertThat(response.serviceName()).isEqualTo("Planner");
    assertThat(response.serviceType()).isEqualTo("PATH_PLANNER");
    assertThat(response.status()).isEqualTo(ServiceStatus.RUNNING);
    assertThat(response.host()).isNotEmpty();
    assertThat(response.uptime()).isEqualTo(2.0);
    assertThat(response.version()).isNotEmpty();
    assertThat(response.systemId()).isEqualTo(ServiceKit.SYSTEM_ID);
  }

  @Test
  void functionalityRequest_isAnsweredWithChannelsAndTypes() {
    FunctionalityResponse response =
        answer(
            Channels.FUNCTIONALITY,
            new FunctionalityRequest().serviceName("Planner"),
            FunctionalityResponse.class);

    assertThat(response.publishes()).containsExactly("navigation/NavigationPoint");
    assertThat(response.subscribes()).containsExactly("state/StateInformation");
  }

  @Test
  void functionalityRequest_forAnother_isNotAnswered() {
    kit.publish(Channels.FUNCTIONALITY, new FunctionalityRequest().serviceName("Other"));

    assertThat(kit.published(Channels.FUNCTIONALITY)).isEmpty();
  }

  @Test
  void configurationRequest_isAnsweredWithAllVariables() {
    ConfigurationResponse response =
        answer(
            Channels.CONFIGURATION,
            new ConfigurationRequest().serviceName("Planner"),
            ConfigurationResponse.class);

    assertThat(response.variables())
        .anySatisfy(
            variable -> {
              assertThat(variable.name()).isEqualTo("GAIN");
              assertThat(variable.value()).isEqualTo("2.0");
            });
  }

  @Test
  void configurationChange_valid_isSetAndTheHookIsCalled() {
    ConfigurationChangeResult result =
        answer(
            Channels.CONFIGURATION,
            new ConfigurationChange().serviceName("Planner").variableName("GAIN").value("3.5"),
            ConfigurationChangeResult.class);

    assertThat(result.accepted()).isTrue();
    assertThat(planner.getVariable("GAIN")).isEqualTo(3.5);
    assertThat(planner.changed).containsExactly("GAIN=3.5");
  }

  @Test
  void configurationChange_outOfRange_isRefusedWithTheReason() {
    ConfigurationChangeResult result =
        answer(
            Channels.CONFIGURATION,
            new ConfigurationChange().serviceName("Planner").variableName("GAIN").value("11"),
            ConfigurationChangeResult.class);

    assertThat(result.accepted()).isFalse();
    assertThat(result.reason()).contains("GAIN").contains("10");
    assertThat(planner.getVariable("GAIN")).isEqualTo(2.0);
    assertThat(planner.changed).isEmpty();
  }

  @Test
  void publish_fillsInSystemAndTimeAndFreezes() {
    NavigationPoint point = NavigationPoint.at(Point.of(1.0, 0.0, 0.0));
    kit.advance(1.5);

    assertThat(planner.publish(point)).isTrue();

    assertThat(point.systemId()).isEqualTo(ServiceKit.SYSTEM_ID);
    assertThat(point.timestamp()).hasValue(1_500_000L);
    assertThat(point.isFrozen()).isTrue();
    assertThat(kit.latest(Channels.NAVIGATION)).contains(point);
  }

  @Test
  void publish_notRegistered_isRefusedAndLogged() {
    assertThat(planner.publish(new StateInformation())).isFalse();
    assertThat(kit.log("Planner"))
        .anyMatch(line -> line.contains("not registered as a publisher of StateInformation"));
  }

  @Test
  void getThreadId_isTheThreadsOwn() {
    assertThat(planner.getThreadID()).isEqualTo((int) planner.getId());
    assertThat(planner.isRunning()).isTrue();
    assertThat(planner.getServiceName()).isEqualTo("Planner");
  }
}
