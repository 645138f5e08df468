package org.u2sa.recorder.mcap;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.zip.ZipInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.recorder.mcap.record.AttachmentIndex;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapAttachment;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.mcap.record.MetadataIndex;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordFields;

/**
 * The conformance data of MCAP's own repository (github.com/foxglove/mcap, tests/conformance/data,
 * MIT): descriptions of 416 files and the SHA-256 of each. What we write must be those files, and
 * what we read of them must be what is described.
 */
class McapConformanceTest {
  private static final Map<String, McapFeature> FEATURES =
      Map.of(
          "ch", McapFeature.CHUNKS,
          "mx", McapFeature.MESSAGE_INDEX,
          "st", McapFeature.STATISTICS,
          "rsh", McapFeature.REPEATED_SCHEMAS,
          "rch", McapFeature.REPEATED_CHANNELS,
          "ax", McapFeature.ATTACHMENT_INDEX,
          "mdx", McapFeature.METADATA_INDEX,
          "chx", McapFeature.CHUNK_INDEX,
          "sum", McapFeature.SUMMARY_OFFSETS,
          "pad", McapFeature.LATER_FIELDS);

  @TempDir Path folder;

  @Test
  void write_each416Descriptions_givesTheFilesByteForByte() throws IOException {
    List<String> different = new ArrayList<>();
    JsonNode all = descriptions();
    for (JsonNode variant : all) {
      byte[] bytes = Files.readAllBytes(written(variant));
      if (bytes.length != variant.get("size").asInt()
          || !sha256(bytes).equals(variant.get("sha256").asText())) {
        different.add(variant.get("name").asText());
      }
    }
    assertThat(all).hasSize(416);
    assertThat(different).isEmpty();
  }

  @Test
  void read_each416Files_givesTheRecordsDescribed() throws IOException {
    for (JsonNode variant : descriptions()) {
      List<Map<String, Object>> expected = new ArrayList<>();
      variant.get("records").forEach(record -> expected.add(described(record)));
      assertThat(read(written(variant))).as(variant.get("name").asText()).isEqualTo(expected);
    }
  }

  private static JsonNode descriptions() throws IOException {
    try (InputStream in = McapConformanceTest.class.getResourceAsStream("conformance.zip");
        ZipInputStream zip = new ZipInputStream(in)) {
      while (!zip.getNextEntry().getName().equals("conformance.json")) {
        continue; // the licence
      }
      return new ObjectMapper().readTree(zip.readAllBytes());
    }
  }

  private Path written(JsonNode variant) throws IOException {
    Set<McapFeature> features = EnumSet.noneOf(McapFeature.class);
    variant.at("/meta/variant/features").forEach(name -> features.add(FEATURES.get(name.asText())));
    Path file = folder.resolve(variant.get("name").asText() + ".mcap");
    McapOptions options =
        new McapOptions(features, ChunkCompression.NONE, 1 << 20, Long.MAX_VALUE, "", "");
    Files.deleteIfExists(file);
    FileChannel channel =
        FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    try (McapWriter writer = new McapWriter(channel, options)) {
      for (JsonNode record : variant.get("records")) {
        if (record.get("type").asText().equals("DataEnd")) {
          break;
        }
        add(writer, record.get("type").asText(), fields(record));
      }
    }
    return file;
  }

  private static void add(McapWriter writer, String type, Map<String, JsonNode> f)
      throws IOException {
    switch (type) {
      case "Header" -> assertThat(f.get("library").asText()).isEmpty();
      case "Schema" ->
          writer.add(
              new McapSchema(
                  f.get("id").asInt(),
                  f.get("name").asText(),
                  f.get("encoding").asText(),
                  bytes(f.get("data"))));
      case "Channel" ->
          writer.add(
              new McapChannel(
                  f.get("id").asInt(),
                  f.get("schema_id").asInt(),
                  f.get("topic").asText(),
                  f.get("message_encoding").asText(),
                  texts(f.get("metadata"))));
      case "Message" ->
          writer.add(
              new McapMessage(
                  f.get("channel_id").asInt(),
                  f.get("sequence").asLong(),
                  f.get("log_time").asLong(),
                  f.get("publish_time").asLong(),
                  bytes(f.get("data"))));
      case "Attachment" ->
          writer.add(
              new McapAttachment(
                  f.get("log_time").asLong(),
                  f.get("create_time").asLong(),
                  f.get("name").asText(),
                  f.get("media_type").asText(),
                  bytes(f.get("data"))));
      case "Metadata" ->
          writer.add(new McapMetadata(f.get("name").asText(), texts(f.get("metadata"))));
      default -> throw new IllegalArgumentException(type);
    }
  }

  private static Map<String, JsonNode> fields(JsonNode record) {
    Map<String, JsonNode> fields = new TreeMap<>();
    record.get("fields").forEach(pair -> fields.put(pair.get(0).asText(), pair.get(1)));
    return fields;
  }

  private static byte[] bytes(JsonNode list) {
    byte[] bytes = new byte[list.size()];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) list.get(i).asInt();
    }
    return bytes;
  }

  private static Map<String, String> texts(JsonNode object) {
    Map<String, String> texts = new LinkedHashMap<>();
    object.fields().forEachRemaining(entry -> texts.put(entry.getKey(), entry.getValue().asText()));
    return texts;
  }

  /** As {@link #read} says it: numbers and bytes as texts. */
  private static Map<String, Object> described(JsonNode record) {
    Map<String, Object> fields = new TreeMap<>();
    fields.put("type", record.get("type").asText());
    fields(record)
        .forEach(
            (name, value) -> {
              if (value.isObject()) {
                fields.put(name, texts(value));
              } else if (value.isArray()) {
                fields.put(name, HexFormat.of().formatHex(bytes(value)));
              } else {
                fields.put(name, value.asText());
              }
            });
    return fields;
  }

  private static List<Map<String, Object>> read(Path file) throws IOException {
    List<Map<String, Object>> records = new ArrayList<>();
    try (FileChannel channel = FileChannel.open(file)) {
      RecordWalk walk = new RecordWalk(channel);
      for (RecordStream.Entry e = walk.next(); e != null; e = walk.next()) {
        records.add(fieldsOf(e));
      }
    }
    return records;
  }

  private static Map<String, Object> fieldsOf(RecordStream.Entry entry) throws McapException {
    RecordFields in = entry.fields();
    switch (entry.opcode()) {
      case Opcode.HEADER:
        return record("Header", "profile", in.string(), "library", in.string());
      case Opcode.FOOTER:
        return record(
            "Footer",
            "summary_start",
            in.uint64(),
            "summary_offset_start",
            in.uint64(),
            "summary_crc",
            in.uint32());
      case Opcode.DATA_END:
        return record("DataEnd", "data_section_crc", in.uint32());
      case Opcode.SCHEMA:
        McapSchema s = McapSchema.read(in);
        return record(
            "Schema", "id", s.id(), "name", s.name(), "encoding", s.encoding(), "data", s.data());
      case Opcode.CHANNEL:
        McapChannel c = McapChannel.read(in);
        return record(
            "Channel",
            "id",
            c.id(),
            "schema_id",
            c.schemaId(),
            "topic",
            c.topic(),
            "message_encoding",
            c.messageEncoding(),
            "metadata",
            c.metadata());
      case Opcode.MESSAGE:
        McapMessage m = McapMessage.read(in);
        return record(
            "Message",
            "channel_id",
            m.channelId(),
            "sequence",
            m.sequence(),
            "log_time",
            m.logTimeNanos(),
            "publish_time",
            m.publishTimeNanos(),
            "data",
            m.data());
      case Opcode.ATTACHMENT:
        McapAttachment a = McapAttachment.read(in);
        return record(
            "Attachment",
            "log_time",
            a.logTimeNanos(),
            "create_time",
            a.createTimeNanos(),
            "name",
            a.name(),
            "media_type",
            a.mediaType(),
            "data",
            a.data());
      case Opcode.METADATA:
        McapMetadata d = McapMetadata.read(in);
        return record("Metadata", "name", d.name(), "metadata", d.entries());
      case Opcode.METADATA_INDEX:
        MetadataIndex di = MetadataIndex.read(in);
        return record(
            "MetadataIndex", "offset", di.offset(), "length", di.length(), "name", di.name());
      case Opcode.ATTACHMENT_INDEX:
        AttachmentIndex ai = AttachmentIndex.read(in);
        return record(
            "AttachmentIndex",
            "offset",
            ai.offset(),
            "length",
            ai.length(),
            "log_time",
            ai.logTimeNanos(),
            "create_time",
            ai.createTimeNanos(),
            "data_size",
            ai.size(),
            "name",
            ai.name(),
            "media_type",
            ai.mediaType());
      case Opcode.STATISTICS:
        McapStatistics st = McapStatistics.read(in);
        return record(
            "Statistics",
            "message_count",
            st.messages(),
            "schema_count",
            st.schemas(),
            "channel_count",
            st.channels(),
            "attachment_count",
            st.attachments(),
            "metadata_count",
            st.metadata(),
            "chunk_count",
            st.chunks(),
            "message_start_time",
            st.startNanos(),
            "message_end_time",
            st.endNanos(),
            "channel_message_counts",
            st.messagesByChannel());
      case Opcode.CHUNK_INDEX:
        ChunkIndex ci = ChunkIndex.read(in);
        return record(
            "ChunkIndex",
            "message_start_time",
            ci.startNanos(),
            "message_end_time",
            ci.endNanos(),
            "chunk_start_offset",
            ci.offset(),
            "chunk_length",
            ci.length(),
            "message_index_offsets",
            ci.messageIndexes(),
            "message_index_length",
            ci.messageIndexLength(),
            "compression",
            ci.compression(),
            "compressed_size",
            ci.compressedSize(),
            "uncompressed_size",
            ci.size());
      case Opcode.SUMMARY_OFFSET:
        return record(
            "SummaryOffset",
            "group_opcode",
            in.uint8(),
            "group_start",
            in.uint64(),
            "group_length",
            in.uint64());
      default:
        throw new IllegalArgumentException("opcode " + entry.opcode());
    }
  }

  private static Map<String, Object> record(String type, Object... namesAndValues) {
    Map<String, Object> fields = new TreeMap<>();
    fields.put("type", type);
    for (int i = 0; i < namesAndValues.length; i += 2) {
      Object value = namesAndValues[i + 1];
      Object said = String.valueOf(value);
      if (value instanceof byte[] bytes) {
        said = HexFormat.of().formatHex(bytes);
      } else if (value instanceof Map<?, ?> map) {
        Map<String, String> texts = new LinkedHashMap<>();
        map.forEach((key, text) -> texts.put(String.valueOf(key), String.valueOf(text)));
        said = texts;
      }
      fields.put((String) namesAndValues[i], said);
    }
    return fields;
  }

  private static String sha256(byte[] bytes) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }
}
