package org.u2sa.cli.services;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.services.ServiceGraph;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.directory.ServiceDirectory;

class ServiceGraphTest {
  private final ServiceDirectory directory =
      new ServiceDirectory(new LockstepClock(), (channel, request) -> {});

  private void add(String name, ServiceRole role, List<String> publishes, List<String> subscribes) {
    directory.take(
        new DiscoveryResponse()
            .serviceName(name)
            .serviceType(role.name())
            .status(ServiceStatus.RUNNING));
    directory.take(
        new FunctionalityResponse().serviceName(name).publishes(publishes).subscribes(subscribes));
  }

  private ServiceGraph graph() {
    return ServiceGraph.of(directory.services());
  }

  @Test
  void of_services_standInTheOrderInWhichDataFlow() {
    add("A", ServiceRole.ACTUATOR, List.of(), List.of());
    add("B", ServiceRole.CONTROL_SYSTEM, List.of(), List.of());
    add("C", ServiceRole.PROPRIOCEPTIVE_SENSOR, List.of(), List.of());

    assertThat(graph().services()).containsExactly("C", "B", "A");
  }

  @Test
  void of_subclassIsPublished_feedsWhoTakesTheAncestor() {
    add("From", ServiceRole.OBSERVER, List.of("a/Base/Sub"), List.of());
    add("To", ServiceRole.OBSERVER, List.of(), List.of("a/Base"));

    assertThat(graph().feeds()).containsExactly(new ServiceGraph.Feed("From", "To", "a", "Sub"));
    assertThat(graph().unheard()).isEmpty();
    assertThat(graph().unfed()).isEmpty();
  }

  @Test
  void of_typesOfOneChannelThatDoNotMeet_areLooseEnds() {
    add("From", ServiceRole.OBSERVER, List.of("a/Base/Sub"), List.of());
    add("To", ServiceRole.OBSERVER, List.of(), List.of("a/Base/Other"));

    assertThat(graph().feeds()).isEmpty();
    assertThat(graph().unheard()).containsExactly(new ServiceGraph.Feed("From", "", "a", "Sub"));
    assertThat(graph().unfed()).containsExactly(new ServiceGraph.Feed("", "To", "a", "Other"));
  }

  @Test
  void json_feedsAndLooseEnds_nameWhoIsThere() {
    add("From", ServiceRole.OBSERVER, List.of("a/Base", "b/Base"), List.of());
    add("To", ServiceRole.OBSERVER, List.of(), List.of("a/Base"));

    assertThat(GraphText.json("rover", graph()))
        .startsWith("{\"system\":\"rover\",\"services\":{\"From\":")
        .contains(
            "\"feeds\":[{\"from\":\"From\",\"to\":\"To\",\"channel\":\"a\",\"type\":\"Base\"}]",
            "\"unheard\":[{\"from\":\"From\",\"channel\":\"b\",\"type\":\"Base\"}],\"unfed\":[]");
  }

  @Test
  void of_itsOwnSubscription_isNoFeed() {
    add("Alone", ServiceRole.OBSERVER, List.of("a/Base"), List.of("a/Base"));

    assertThat(graph().feeds()).isEmpty();
    assertThat(graph().unheard()).hasSize(1);
    assertThat(graph().unfed()).hasSize(1);
  }

  @Test
  void lines_subscriberHasNotAnsweredYet_areMarkedAsWhatIsKnown() {
    add("From", ServiceRole.OBSERVER, List.of("a/Base"), List.of());
    directory.take(new HealthReport().serviceName("Late").status(ServiceStatus.RUNNING));

    assertThat(graph().unanswered()).containsExactly("Late");
    assertThat(graph().roles()).containsEntry("Late", "no answer");
    assertThat(GraphText.lines(graph()))
        .contains("Published without subscribers that has answered:")
        .contains("Discovered, but without an answer: Late")
        .doesNotContain("Published without subscribers:");
  }

  @Test
  void of_channelsOfTheContract_areLeftOut() {
    add("One", ServiceRole.OBSERVER, List.of("health/HealthReport", "stop/StopCommand"), List.of());
    add("Two", ServiceRole.OBSERVER, List.of(), List.of("health/HealthReport"));

    assertThat(graph().feeds()).isEmpty();
    assertThat(graph().unheard()).isEmpty();
    assertThat(graph().unfed()).isEmpty();
  }

  @Test
  void dot_namesWithQuotes_staySafe() {
    add("Odd \"one\" \\", ServiceRole.OBSERVER, List.of("a/Base"), List.of());

    assertThat(GraphText.dot("x", graph()))
        .anySatisfy(line -> assertThat(line).contains("\"Odd \\\"one\\\" \\\\\""));
  }

  @Test
  void mermaid_feedsAndLooseEnds_areArrowsBetweenNamedBoxes() {
    add("From \"1\"", ServiceRole.OBSERVER, List.of("a/Base"), List.of("b/Base"));
    add("To", ServiceRole.OBSERVER, List.of(), List.of("a/Base"));

    assertThat(GraphText.mermaid(graph()))
        .containsExactly(
            "flowchart LR",
            "  s0[\"From #quot;1#quot;<br/>observer\"]",
            "  s1[\"To<br/>observer\"]",
            "  s0 -->|\"a<br/>Base\"| s1",
            "  nobody0(( ))",
            "  nobody0 -.->|\"b<br/>Base\"| s0");
  }
}
