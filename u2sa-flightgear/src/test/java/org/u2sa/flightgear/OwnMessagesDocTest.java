package org.u2sa.flightgear;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.control.fixedwing.ControlStatus;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/** Holds the table of the Cessna's own message in docs/wire-protocol.md to their schemas. */
class OwnMessagesDocTest {
  @Test
  void table_ofTheCessnasMessage_namesFieldsUnitsAndBits() throws IOException {
    String page = Files.readString(Paths.get("../docs/wire-protocol.md"), UTF_8);

    assertThat(rows(page, "`ControlStatus`, chain"))
        .containsExactlyElementsOf(own(ControlStatus.TYPE, U2SAData.TYPE));
  }

  private static List<String> own(MessageType<?> type, MessageType<?> parent) {
    List<String> inherited = parent.fields().stream().map(MessageField::name).toList();
    List<String> rows = new ArrayList<>();
    for (MessageField<?> field : type.fields()) {
      if (!inherited.contains(field.name())) {
        String bit = field.bit().isPresent() ? " " + field.bit().getAsInt() : "";
        rows.add(field.name() + " " + field.unit() + bit);
      }
    }
    return rows;
  }

  /** Name, unit and bit of each row of the table that follows the words. */
  private static List<String> rows(String page, String words) {
    List<String> rows = new ArrayList<>();
    String from = page.substring(page.indexOf(words));
    for (String line : from.substring(from.indexOf("|---")).split("\n")) {
      if (!line.startsWith("|")) {
        break;
      }
      String[] cells = line.replaceAll("^\\| *| *\\|$", "").split(" *\\| *", -1);
      rows.add((cells[0] + " " + cells[2] + (cells[4].isEmpty() ? "" : " " + cells[4])));
    }
    return rows.subList(1, rows.size());
  }
}
