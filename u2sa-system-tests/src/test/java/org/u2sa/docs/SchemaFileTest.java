package org.u2sa.docs;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.control.fixedwing.ControlStatus;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.AccessRule;
import org.u2sa.core.security.AccessTable;
import org.u2sa.flightgear.link.Simulator;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.Kind;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * docs/schema/u2sa-messages.json has every channel and message, for clients in other languages. To
 * write it again: -Du2sa.docs.write=true.
 */
class SchemaFileTest {
  private static final Path FILE = Page.ROOT.resolve("docs/schema/u2sa-messages.json");

  private final StringWriter text = new StringWriter();
  private final JsonGenerator json;

  SchemaFileTest() throws IOException {
    json = new JsonFactory().createGenerator(text);
    json.setPrettyPrinter(
        new DefaultPrettyPrinter().withObjectIndenter(new DefaultIndenter("  ", "\n")));
  }

  @Test
  void file_hasTheChannelsAndMessagesOfTheCode() throws IOException {
    String schema = schema();
    if (Boolean.getBoolean("u2sa.docs.write")) {
      Files.createDirectories(FILE.getParent());
      Files.writeString(FILE, schema);
    }
    assertThat(Files.readString(FILE)).isEqualTo(schema);
  }

  private String schema() throws IOException {
    Collection<MessageType<?>> standard = StandardTypes.registry().all();
    json.writeStartObject();
    json.writeStringField("writtenBy", "SchemaFileTest from the Java message types; do not edit");
    json.writeArrayFieldStart("channels");
    for (Channel<?> channel : Channels.all()) {
      channel(channel, "");
    }
    channel(Simulator.TRUTH, "cessna");
    channel(ControlStatus.CHANNEL, "cessna");
    json.writeEndArray();
    json.writeArrayFieldStart("messages");
    for (MessageType<?> type : standard) {
      message(type, "");
    }
    for (MessageType<?> type : MessageTypes.discovered().all()) {
      if (!standard.contains(type)) {
        message(type, "cessna");
      }
    }
    json.writeEndArray();
    json.writeEndObject();
    json.close();
    return text + "\n";
  }

  /**
   * A channel.
   *
   * @param system whose own it is; empty: everybody's
   */
  private void channel(Channel<?> channel, String system) throws IOException {
    json.writeStartObject();
    json.writeStringField("name", channel.name());
    json.writeStringField("system", system);
    json.writeNumberField("qos", channel.deliversEvery() || channel.isRetained() ? 1 : 0);
    json.writeBooleanField("retained", channel.isRetained());
    json.writeStringField("source", source(channel));
    texts("types", channel.carriedTypes().stream().map(MessageType::name).toList());
    json.writeObjectFieldStart("publishers"); // by type, which roles may
    for (AccessRule rule : AccessTable.all()) {
      if (rule.channel().equals(channel)) {
        texts(rule.type().name(), rule.roles().stream().sorted().map(AccessRole::text).toList());
      }
    }
    json.writeEndObject();
    json.writeEndObject();
  }

  /** The field that stands in the topic of a channel that retains a message of each source. */
  private static <T extends U2SAData> String source(Channel<T> channel) {
    if (!channel.isRetainedBySource()) {
      return "";
    }
    T sample = channel.type().create();
    for (MessageField<T> field : channel.type().fields()) {
      if (field.kind() == Kind.STRING) {
        field.set(sample, field.name());
      }
    }
    return channel.sourceOf(sample);
  }

  private <T extends U2SAData> void message(MessageType<T> type, String system) throws IOException {
    json.writeStartObject();
    json.writeStringField("name", type.name());
    json.writeStringField("system", system);
    texts("chain", type.chain());
    json.writeBooleanField("abstract", type.isAbstract());
    json.writeStringField("meaning", plain(Meanings.ofClass(type.messageClass())));
    json.writeArrayFieldStart("fields");
    for (MessageField<T> field : type.fields()) {
      field(type, field);
    }
    json.writeEndArray();
    json.writeEndObject();
  }

  private <T extends U2SAData> void field(MessageType<T> type, MessageField<T> field)
      throws IOException {
    json.writeStartObject();
    json.writeStringField("name", field.name());
    json.writeStringField("kind", kind(field.kind()));
    json.writeStringField("unit", field.unit());
    if (!field.unitIn(ReferenceFrame.GLOBAL).equals(field.unit())) {
      json.writeStringField("unitInGlobal", field.unitIn(ReferenceFrame.GLOBAL));
    }
    if (field.isRequired() || field.isOptional()) {
      json.writeStringField("presence", field.isRequired() ? "required" : "optional");
    } else {
      json.writeStringField("presence", "always");
      ifUnset(FieldDefaults.of(type, field));
    }
    if (field instanceof NumberField<?> number) {
      bound("min", number.min());
      bound("max", number.max());
    } else if (field instanceof ValueField<?, ?> value) {
      if (!value.constants().isEmpty()) {
        json.writeObjectFieldStart("constants");
        for (Object constant : value.constants()) {
          json.writeStringField(constant.toString(), plain(Meanings.ofConstant(constant)));
        }
        json.writeEndObject();
      }
      if (value.maxLength().isPresent()) {
        json.writeNumberField("maxLength", value.maxLength().getAsInt());
        json.writeBooleanField("shortens", value.shortens());
      }
      if (type.elementType(field).isPresent()) {
        json.writeStringField("element", type.elementType(field).get().name());
      }
    }
    if (field.bit().isPresent()) {
      json.writeNumberField("bit", field.bit().getAsInt());
    }
    json.writeNumberField("since", field.since());
    json.writeStringField("meaning", plain(Meanings.ofField(type, field.name())));
    json.writeEndObject();
  }

  private void ifUnset(Object present) throws IOException {
    if (present instanceof List) {
      texts("default", List.of()); // all lists start empty
    } else if (present instanceof Double number) {
      json.writeNumberField("default", number);
    } else if (present instanceof Long number) {
      json.writeNumberField("default", number);
    } else if (present instanceof Boolean flag) {
      json.writeBooleanField("default", flag);
    } else {
      json.writeStringField("default", present.toString());
    }
  }

  private void bound(String name, double value) throws IOException {
    if (!Double.isInfinite(value)) {
      json.writeNumberField(name, value);
    }
  }

  private void texts(String name, List<String> values) throws IOException {
    json.writeArrayFieldStart(name);
    for (String value : values) {
      json.writeString(value);
    }
    json.writeEndArray();
  }

  private static String kind(Kind kind) {
    return switch (kind) {
      case DOUBLE -> "float64";
      case LONG -> "int";
      case BOOLEAN -> "bool";
      case STRING -> "text";
      case BYTES -> "bytes";
      case STRING_LIST -> "texts";
      case DOUBLE_LIST -> "numbers";
      case BOOLEAN_LIST -> "flags";
      case ENUM -> "enum";
      case FRAME -> "frame";
      case POINT -> "point";
      case POINT_LIST -> "points";
      case MESSAGE_LIST -> "messages";
    };
  }

  /** Without the escapes that tables need. */
  private static String plain(String meaning) {
    return meaning.replace("\\|", "|");
  }
}
