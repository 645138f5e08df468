package org.u2sa.gcs.view;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import org.u2sa.interfaces.JsonText;

/**
 * A channel as seen by viewers.
 *
 * @param id ID, unique in the server
 * @param topic topic name
 * @param encoding encoding of the messages: json or protobuf
 * @param schemaName name of the message type
 * @param schema schema of the type: JSON Schema or a FileDescriptorSet; not copied, must not be
 *     modified
 * @param latched whether late viewers are sent the last message
 */
record ViewChannel(
    int id, String topic, String encoding, String schemaName, byte[] schema, boolean latched) {
  static final String JSON = "json";
  static final String PROTOBUF = "protobuf";

  JsonText advertisement() {
    boolean json = encoding.equals(JSON);
    return new JsonText()
        .put("id", id)
        .put("topic", topic)
        .put("encoding", encoding)
        .put("schemaName", schemaName)
        .put(
            "schema",
            json
                ? new String(schema, StandardCharsets.UTF_8)
                : Base64.getEncoder().encodeToString(schema))
        .put("schemaEncoding", json ? "jsonschema" : PROTOBUF);
  }
}
