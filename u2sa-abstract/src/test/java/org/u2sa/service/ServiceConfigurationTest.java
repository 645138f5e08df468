package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationChangeResult;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.ServiceKit;

/** Changes of several variables and undo, as every service answers them (thesis 3.2.1.1). */
@Timeout(120)
class ServiceConfigurationTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();
  private Tuned service;

  private static final class Tuned extends EventDrivenService {
    private static final VariableDeclaration<Double> LOW =
        VariableDeclaration.number("LOW", "m").range(Range.of(0.0, 10.0)).ifAbsent(2.0);
    private static final VariableDeclaration<Double> HIGH =
        VariableDeclaration.number("HIGH", "m").range(Range.of(0.0, 10.0)).ifAbsent(5.0);
    private static final VariableDeclaration<String> MODE =
        VariableDeclaration.text("MODE").oneOf("SLOW", "FAST").ifAbsent("SLOW");
    private final List<Set<String>> changed = new ArrayList<>();

    Tuned(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Tuned");
      getVariable(LOW);
      getVariable(HIGH);
      getVariable(MODE);
    }

    @Override
    protected Optional<String> configurationRefusal(Map<String, Object> values) {
      return (Double) values.get("LOW") < (Double) values.get("HIGH")
          ? Optional.empty()
          : Optional.of("LOW must be below HIGH");
    }

    @Override
    protected void configurationChanged(Set<String> variableNames) {
      changed.add(variableNames);
    }
  }

  @BeforeEach
  void start() {
    service = kit.start(Tuned::new);
  }

  private <T extends U2SAData> T answer(U2SAData request, Class<T> type) {
    kit.publish(Channels.CONFIGURATION, request);
    return type.cast(kit.latest(Channels.CONFIGURATION).orElseThrow());
  }

  private static ConfigurationTransaction transaction(String id, String... namesAndValues) {
    List<ConfigurationAssignment> assignments = new ArrayList<>();
    for (int i = 0; i < namesAndValues.length; i += 2) {
      assignments.add(
          new ConfigurationAssignment()
              .variableName(namesAndValues[i])
              .value(namesAndValues[i + 1]));
    }
    return new ConfigurationTransaction()
        .requestId(id)
        .serviceName("Tuned")
        .author("ann")
        .assignments(assignments);
  }

  private ConfigurationTransactionResult transact(ConfigurationTransaction transaction) {
    return answer(transaction, ConfigurationTransactionResult.class);
  }

  private ConfigurationTransactionResult undo(String id) {
    return answer(
        new ConfigurationUndo().requestId(id).serviceName("Tuned").author("bob"),
        ConfigurationTransactionResult.class);
  }

  @Test
  void transaction_twoVariables_areSetAndTheHookIsCalledOnce() {
    ConfigurationTransactionResult result = transact(transaction("1", "LOW", "6", "HIGH", "7"));

    assertThat(result.accepted()).isTrue();
    assertThat(result.requestId()).isEqualTo("1");
    assertThat(result.author()).isEqualTo("ann");
    assertThat(result.revision()).isEqualTo(1);
    assertThat(result.assignments())
        .extracting(assignment -> assignment.previous().orElse(""))
        .containsExactly("2.0", "5.0");
    assertThat(service.changed).containsExactly(Set.of("LOW", "HIGH"));
    assertThat(kit.log("Tuned"))
        .anyMatch(line -> line.contains("\"HIGH\" changed by \"ann\": 5.0 → 7.0 (revision 1)"));
  }

  @Test
  void transaction_valuesThatDoNotGoTogether_areRefusedByTheServicesWord() {
    ConfigurationTransactionResult result = transact(transaction("1", "LOW", "6"));

    assertThat(result.accepted()).isFalse();
    assertThat(result.reason()).endsWith("LOW must be below HIGH");
    assertThat(service.getVariable("LOW")).isEqualTo(2.0);
    assertThat(service.changed).isEmpty();
    assertThat(service.setVariable("LOW", 6)).isFalse();
  }

  @Test
  void transaction_nothingOrOneNameTwice_isRefused() {
    assertThat(transact(transaction("1")).reason()).endsWith("no variable to change is named");
    assertThat(transact(transaction("2", "LOW", "1", "LOW", "3")).reason())
        .isEqualTo("variable \"LOW\" is named twice");
  }

  @Test
  void transaction_oldRevision_isRefusedAndNamesTheOtherWriter() {
    transact(transaction("1", "LOW", "3"));

    ConfigurationTransactionResult result =
        transact(transaction("2", "HIGH", "9").revision(0).author("bob"));

    assertThat(result.accepted()).isFalse();
    assertThat(result.reason()).contains("\"ann\": \"LOW\" 2.0 → 3.0 (revision 1)");
    assertThat(result.revision()).isEqualTo(1);
  }

  @Test
  void undo_sentTwiceByTheNetwork_isDoneOnce() {
    transact(transaction("1", "LOW", "3"));
    transact(transaction("2", "LOW", "4"));

    ConfigurationTransactionResult first = undo("3");
    ConfigurationTransactionResult second = undo("3");

    assertThat(first.accepted()).isTrue();
    assertThat(second).isEqualTo(first);
    assertThat(service.getVariable("LOW")).isEqualTo(3.0);
    assertThat(service.changed).hasSize(3);
  }

  /** The service may be restarted between the two deliveries. */
  @Test
  void transaction_sentTwiceByTheNetworkAroundARestart_isAnsweredAgainAndDoneOnce() {
    ConfigurationTransaction order = transaction("1", "LOW", "3");
    ConfigurationTransactionResult first = transact(order);
    transact(transaction("1", "LOW", "4"));

    service = kit.restart(service, Tuned::new);
    transact(transaction("2", "LOW", "4.5"));
    ConfigurationTransactionResult second = transact(order);

    assertThat(second).isEqualTo(first);
    assertThat(service.getVariable("LOW")).isEqualTo(4.5);
  }

  @Test
  void change_sentTwiceByTheNetwork_isDoneOnce() {
    ConfigurationChange order =
        new ConfigurationChange().serviceName("Tuned").variableName("LOW").value("3");
    ConfigurationChangeResult first = answer(order, ConfigurationChangeResult.class);
    transact(transaction("1", "LOW", "4"));

    assertThat(answer(order, ConfigurationChangeResult.class)).isEqualTo(first);
    assertThat(service.getVariable("LOW")).isEqualTo(4.0);
  }

  @Test
  void transactions_underOneIdAtOnce_areBothDone() {
    kit.send(Channels.CONFIGURATION, transaction("1", "LOW", "3"));
    kit.publish(Channels.CONFIGURATION, transaction("1", "MODE", "FAST"));

    assertThat(service.getVariable("LOW")).isEqualTo(3.0);
    assertThat(service.getVariable("MODE")).isEqualTo("FAST");
  }

  @Test
  void stop_sentTwiceByTheNetworkAroundARestart_isObeyedOnce() {
    StopCommand order = new StopCommand().serviceName("Tuned");
    kit.publish(Channels.STOP, order);
    assertThat(service.isRunning()).isFalse();

    service = kit.restart(service, Tuned::new);
    kit.publish(Channels.STOP, order);
    assertThat(service.isRunning()).isTrue();

    kit.advance(0.1);
    kit.publish(Channels.STOP, new StopCommand().serviceName("Tuned"));
    assertThat(service.isRunning()).isFalse();
  }

  @Test
  void undo_ofNothing_isRefused() {
    ConfigurationTransactionResult result = undo("1");

    assertThat(result.accepted()).isFalse();
    assertThat(result.reason()).contains("there is no recorded change to undo");
  }

  @Test
  void request_tellsRevisionAndChoices() {
    transact(transaction("1", "MODE", "FAST"));

    ConfigurationResponse response =
        answer(new ConfigurationRequest().serviceName("Tuned"), ConfigurationResponse.class);

    assertThat(response.revision()).hasValue(1);
    assertThat(response.variables())
        .anySatisfy(
            variable -> {
              assertThat(variable.name()).isEqualTo("MODE");
              assertThat(variable.value()).isEqualTo("FAST");
              assertThat(variable.choices()).containsExactly("SLOW", "FAST");
            });
  }

  /** A broker keeps orders while a link is down. */
  @Test
  void transaction_olderThanOrderExpiry_isRefused() {
    ConfigurationTransaction late = transaction("1", "MODE", "FAST");
    late.timestamp(kit.clock().micros() - Clock.micros(20.0));

    ConfigurationTransactionResult result = transact(late);

    assertThat(result.accepted()).isFalse();
    assertThat(result.reason()).contains("20.0 s after it was given");
    assertThat(service.getVariable("MODE")).isNotEqualTo("FAST");
    ConfigurationTransaction inTime = transaction("2", "MODE", "FAST");
    inTime.timestamp(kit.clock().micros() - Clock.micros(4.0));
    assertThat(transact(inTime).accepted()).isTrue();
  }

  @Test
  void transaction_serviceWithoutAFile_saysThatARestartForgetsIt() {
    String notSaved =
        "not saved: the service has no configuration file, and forgets this when it is restarted";

    assertThat(transact(transaction("1", "LOW", "3")).reason()).isEqualTo(notSaved);
    assertThat(transact(transaction("2", "LOW", "3")).reason()).isEmpty(); // no change
    assertThat(undo("3").reason()).isEqualTo(notSaved);
  }
}
