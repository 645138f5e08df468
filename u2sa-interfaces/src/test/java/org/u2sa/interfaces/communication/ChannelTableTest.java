package org.u2sa.interfaces.communication;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.schema.U2SAData;

/** Holds the table of channels in docs/wire-protocol.md, from which foreign clients are made. */
class ChannelTableTest {
  @Test
  void table_ofChannels_saysWhatTheCodeDoes() throws IOException {
    List<String> expected = new ArrayList<>();
    for (Channel<?> channel : Channels.all()) {
      int quality = channel.deliversEvery() || channel.isRetained() ? 1 : 0;
      expected.add(channel.name() + " | " + quality + " | " + retained(channel));
    }

    assertThat(rows()).containsExactlyElementsOf(expected);
  }

  private static String retained(Channel<?> channel) {
    if (!channel.isRetained()) {
      return "";
    }
    for (U2SAData sample :
        List.of(
            new PlannedPath().subsystem("subsystem"),
            new ActuatorAnnouncement().actuatorName("actuatorName"),
            new ServiceCondition().serviceName("serviceName"))) {
      if (!channel.sourceOf(sample).isEmpty()) {
        return "of each " + channel.sourceOf(sample);
      }
    }
    return "yes";
  }

  /** Name, QoS and retained flag of each row. */
  private static List<String> rows() throws IOException {
    String page = new String(Files.readAllBytes(Paths.get("../docs/wire-protocol.md")), UTF_8);
    List<String> rows = new ArrayList<>();
    for (String line : page.substring(page.indexOf("| channel |")).split("\n")) {
      if (!line.startsWith("|")) {
        break;
      }
      String[] cells = line.replaceAll("^\\| *| *\\|$", "").split(" *\\| *", -1);
      rows.add(cells[0] + " | " + cells[3] + " | " + cells[4]);
    }
    return rows.subList(2, rows.size());
  }
}
