package org.u2sa.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * Holds the tables of messages in docs/wire-protocol.md to the schemas. To write them again:
 * -Du2sa.docs.write=true.
 */
class MessageTablesTest {
  private static final String BEGIN = "<!-- schemas: written by MessageTablesTest -->\n";
  private static final String END = "<!-- end of schemas -->";

  @Test
  void tables_ofEveryMessage_areThoseOfTheSchemas() throws IOException {
    Path file = Page.ROOT.resolve("docs/wire-protocol.md");
    String page = Files.readString(file);
    int from = page.indexOf(BEGIN) + BEGIN.length();
    if (Boolean.getBoolean("u2sa.docs.write")) {
      page = page.substring(0, from) + tables() + page.substring(page.indexOf(END));
      Files.writeString(file, page);
    }
    assertThat(page.substring(from, page.indexOf(END))).isEqualTo(tables());
  }

  private static String tables() {
    StringBuilder out = new StringBuilder();
    for (MessageType<?> type : StandardTypes.registry().all()) {
      append(out, type);
    }
    out.append("\n### Constants\n\n| class and field | constant | meaning |\n|---|---|---|\n");
    Set<Class<?>> told = new HashSet<>();
    for (MessageType<?> type : StandardTypes.registry().all()) {
      for (MessageField<?> field : type.fields()) {
        if (field instanceof ValueField<?, ?> value && !value.constants().isEmpty()) {
          appendConstants(out, type.name() + "." + field.name(), value.constants(), told);
        }
      }
    }
    return out.toString();
  }

  private static void appendConstants(
      StringBuilder out, String field, List<?> constants, Set<Class<?>> told) {
    if (!told.add(constants.get(0).getClass())) {
      return;
    }
    for (Object constant : constants) {
      out.append("| ").append(field).append(" | ").append(constant);
      out.append(" | ").append(Meanings.ofConstant(constant)).append(" |\n");
    }
  }

  private static <T extends U2SAData> void append(StringBuilder out, MessageType<T> type) {
    out.append("\n### ").append(type.name()).append("\n\n");
    out.append("Type chain `").append(String.join("/", type.chain())).append('`');
    out.append(type.isAbstract() ? ", abstract: only subclasses travel.\n\n" : ".\n\n");
    out.append(Meanings.ofClass(type.messageClass())).append("\n\n");
    out.append("| field | CBOR | unit | presence | bit | since | meaning |\n");
    out.append("|---|---|---|---|---|---|---|\n");
    for (MessageField<T> field : type.fields()) {
      out.append("| ").append(field.name());
      out.append(" | ").append(cborType(type, field));
      out.append(" | ").append(unit(field));
      out.append(" | ").append(presence(type, field));
      out.append(" | ").append(field.bit().isPresent() ? field.bit().getAsInt() : "");
      out.append(" | ").append(field.since());
      out.append(" | ").append(Meanings.ofField(type, field.name())).append(" |\n");
    }
  }

  private static String cborType(MessageType<?> type, MessageField<?> field) {
    if (field instanceof ValueField<?, ?> value) {
      if (!value.constants().isEmpty()) {
        return "text: " + value.constants().toString().replaceAll("[\\[\\]]", "");
      }
      if (type.elementType(field).isPresent()) {
        return "array of " + type.elementType(field).get().name() + " maps";
      }
      if (value.maxLength().isPresent()) {
        String bound = value.shortens() ? ", shortened to " : ", at most ";
        return value.kind().cborType() + bound + value.maxLength().getAsInt();
      }
    }
    if (field instanceof NumberField<?> number && number.max() < Double.POSITIVE_INFINITY) {
      return "float64, " + number.min() + "…" + number.max();
    }
    if (field instanceof NumberField<?> number && number.min() > Double.NEGATIVE_INFINITY) {
      return "float64, ≥ " + number.min();
    }
    return field.kind().cborType();
  }

  private static String unit(MessageField<?> field) {
    String global = field.unitIn(ReferenceFrame.GLOBAL);
    return global.equals(field.unit()) ? field.unit() : field.unit() + "; GLOBAL: " + global;
  }

  private static <T extends U2SAData> String presence(MessageType<T> type, MessageField<T> field) {
    if (field.isRequired()) {
      return "required";
    }
    if (field.isOptional()) {
      return "optional";
    }
    Object ifUnset = FieldDefaults.of(type, field);
    return "always; " + ("".equals(ifUnset) ? "\"\"" : ifUnset) + " unless set";
  }
}
