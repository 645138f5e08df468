package org.u2sa.core.security;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.OpaqueMessage;

class AccessTableTest {
  private static final Path PAGE = Paths.get("../docs/security.md");
  private static final String BEGIN = "<!-- table of rights: written by AccessTableTest -->\n";
  private static final String END = "<!-- end of the table of rights -->";

  @Test
  void all_typesOfStandardChannels_haveOneRowEach() {
    List<String> expected = new ArrayList<>();
    for (Channel<?> channel : Channels.all()) {
      for (MessageType<?> type : channel.carriedTypes()) {
        expected.add(channel + " " + type);
      }
    }
    assertThat(AccessTable.all())
        .extracting(rule -> rule.channel() + " " + rule.type())
        .containsExactlyElementsOf(expected);
    assertThat(AccessTable.all()).allMatch(rule -> !rule.roles().isEmpty());
  }

  /** Who may stop, arm, change or move something, said once more and apart from the table. */
  @Test
  void all_whatCommandsTheVehicle_isNobodysButTheirs() {
    List<String> commanding =
        AccessTable.all().stream()
            .filter(
                rule ->
                    rule.kind() != AccessRule.Kind.REPORT && rule.kind() != AccessRule.Kind.QUESTION
                        || rule.channel().equals(Channels.ACTUATION)
                        || rule.channel().equals(Channels.CONDITIONS))
            .map(rule -> rule.channel() + " " + rule.type().name() + " " + names(rule))
            .collect(Collectors.toList());

    assertThat(commanding)
        .containsExactlyInAnyOrder(
            "actuation ActuatorCommand control",
            "stop StopCommand operator",
            "configuration ConfigurationChange operator",
            "configuration ConfigurationTransaction operator",
            "configuration ConfigurationUndo operator",
            "service-orders ServiceOrder monitor, operator",
            "emergency-stop EmergencyStop safety, operator",
            "arming ArmCommand operator",
            "arming-state ArmingState safety",
            "failsafe FailsafeState monitor, safety",
            "conditions ServiceCondition monitor",
            "goal-commands GoalCommand operator",
            "mission MissionOrder operator",
            "fence-orders FenceOrder operator",
            "manual-orders ManualOrder operator");
  }

  @Test
  void all_observer_asksAndRetainsNothing() {
    assertThat(AccessTable.all())
        .filteredOn(rule -> rule.roles().contains(AccessRole.OBSERVER))
        .allMatch(rule -> rule.kind() == AccessRule.Kind.QUESTION)
        .noneMatch(rule -> rule.retained() || rule.mayBeWill());
  }

  @Test
  void rule_subclass_isItsNearestAncestors() {
    assertThat(AccessTable.rule("health", ConnectionLost.TYPE).orElseThrow().channel())
        .isEqualTo(Channels.HEALTH);
    assertThat(AccessTable.rule("health", EmergencyStop.TYPE)).isEmpty();
    assertThat(AccessTable.rule("nowhere", EmergencyStop.TYPE)).isEmpty();
  }

  /** What every service has to read must be short; what goes to one may be as long as it is. */
  @ParameterizedTest
  @CsvSource({
    "discovery/DiscoveryRequest, 4096",
    "emergency-stop/EmergencyStop, 16384",
    "configuration/ConfigurationTransaction, 65536",
    "goal-commands/GoalCommand, 2147483647",
    "state/StateInformation, 2147483647"
  })
  void longestPayload_byWhoReadsIt_isBounded(String channelAndType, int bytes) {
    assertThat(AccessTable.all())
        .filteredOn(rule -> channelAndType.equals(rule.channel() + "/" + rule.type().name()))
        .singleElement()
        .extracting(AccessRule::longestPayload)
        .isEqualTo(bytes);
  }

  @Test
  void mayPublishOnOwnChannel_whatHasAChannel_onlyIfItMayThere() {
    EnumSet<AccessRole> service = EnumSet.of(AccessRole.SERVICE);
    assertThat(AccessTable.mayPublishOnOwnChannel(service, StateInformation.TYPE)).isTrue();
    assertThat(AccessTable.mayPublishOnOwnChannel(service, ArmCommand.TYPE)).isFalse();
    assertThat(
            AccessTable.mayPublishOnOwnChannel(
                EnumSet.of(AccessRole.OBSERVER, AccessRole.OPERATOR), StateInformation.TYPE))
        .isFalse();
  }

  /** A type that no standard channel carries: services may say it on channels of their own. */
  @Test
  void mayPublishOnOwnChannel_whatHasNoChannel_anyServiceMay() {
    assertThat(
            AccessTable.mayPublishOnOwnChannel(EnumSet.of(AccessRole.SERVICE), OpaqueMessage.TYPE))
        .isTrue();
    assertThat(
            AccessTable.mayPublishOnOwnChannel(EnumSet.of(AccessRole.OPERATOR), OpaqueMessage.TYPE))
        .isFalse();
  }

  /** What must arrive is delivered at least once; what is measured again soon is not repeated. */
  @Test
  void quality_whatMattersEachOrIsRetained_isAtLeastOnce() {
    assertThat(AccessTable.rule("arming", ArmCommand.TYPE).orElseThrow().quality()).isEqualTo(1);
    assertThat(AccessTable.rule("state", StateInformation.TYPE).orElseThrow().quality()).isZero();
    assertThat(AccessTable.all())
        .filteredOn(rule -> rule.retained() || rule.kind() == AccessRule.Kind.URGENT)
        .isNotEmpty()
        .allMatch(rule -> rule.quality() == 1);
  }

  /** -Du2sa.docs.write=true writes it. */
  @Test
  void page_tableOfRights_isThisOne() throws IOException {
    String page = new String(Files.readAllBytes(PAGE), UTF_8);
    int begin = page.indexOf(BEGIN) + BEGIN.length();
    String expected = page.substring(0, begin) + table() + page.substring(page.indexOf(END));
    if (Boolean.getBoolean("u2sa.docs.write")) {
      Files.write(PAGE, expected.getBytes(UTF_8));
    }
    assertThat(new String(Files.readAllBytes(PAGE), UTF_8)).isEqualTo(expected);
  }

  private static String table() {
    StringBuilder table =
        new StringBuilder("| channel | type | who may publish | kind | retained | as a will |\n");
    table.append("|---|---|---|---|---|---|\n");
    for (AccessRule rule : AccessTable.all()) {
      table.append(
          String.format(
              "| %s | %s | %s | %s | %s | %s |%n",
              rule.channel(),
              rule.type().name(),
              names(rule),
              rule.kind().name().toLowerCase(),
              rule.retained() ? "yes" : "",
              rule.mayBeWill() ? "yes" : ""));
    }
    return table.toString();
  }

  private static String names(AccessRule rule) {
    return rule.roles().size() == AccessRole.values().length
        ? "all"
        : rule.roles().stream().sorted().map(AccessRole::text).collect(Collectors.joining(", "));
  }
}
