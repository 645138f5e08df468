package org.u2sa.cli.security;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Collection;
import java.util.Collections;
import java.util.Optional;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.security.AccessRule;
import org.u2sa.core.security.AccessTable;
import org.u2sa.core.security.SecretFile;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.core.security.User;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;

/** Exports the embedded broker's users and roles to Mosquitto's files (mosquitto.conf(5)). */
final class MosquittoFiles {
  private MosquittoFiles() {}

  /** Writes all files to the folder, with the broker's certificate and key. */
  static void write(
      Path folder, SecurityDirectory directory, Collection<User> users, String bind, int port)
      throws IOException {
    Files.copy(
        directory.certificate(), folder.resolve("server.pem"), StandardCopyOption.REPLACE_EXISTING);
    SecretFile.write(folder.resolve("server-key.pem"), Files.readAllBytes(directory.key()));
    write(folder.resolve("passwords"), passwords(users));
    write(folder.resolve("acl"), rights(users, MessageTypes.discovered()));
    write(folder.resolve("mosquitto.conf"), configuration(folder, bind, port));
  }

  private static void write(Path file, String text) {
    SecretFile.write(file, text.getBytes(StandardCharsets.UTF_8));
  }

  private static String configuration(Path folder, String bind, int port) {
    return String.join(
        "\n",
        "# Written by ./u2sa security mosquitto.",
        "listener " + port + " " + bind,
        "certfile " + folder.resolve("server.pem"),
        "keyfile " + folder.resolve("server-key.pem"),
        "tls_version tlsv1.2",
        "allow_anonymous false",
        "password_file " + folder.resolve("passwords"),
        "acl_file " + folder.resolve("acl"),
        "persistence false",
        "max_connections 512",
        "max_packet_size " + BrokerLimits.LONGEST_PACKET,
        "max_queued_messages 1000",
        "max_queued_bytes 16777216",
        "set_tcp_nodelay true",
        "");
  }

  private static String passwords(Collection<User> users) {
    StringBuilder text = new StringBuilder();
    users.forEach(
        user ->
            text.append(user.name())
                .append(':')
                .append(user.password().forMosquitto())
                .append('\n'));
    return text.toString();
  }

  /**
   * Permissions by topic: exactly each type's own chain on each channel. A filter that included
   * unknown subclasses would also match known types below them.
   */
  static String rights(Collection<User> users, MessageTypes types) {
    StringBuilder text = new StringBuilder("# Written by ./u2sa security mosquitto.\n");
    for (User user : users) {
      text.append("\n# ")
          .append(user.rolesText())
          .append("\nuser ")
          .append(user.name())
          .append('\n');
      for (String system : user.systems()) {
        String base = "u2sa/" + (system.equals(User.EVERY_SYSTEM) ? "+" : system) + "/";
        text.append("topic read ").append(base).append("#\n");
        for (AccessRule rule : AccessTable.all()) {
          if (!Collections.disjoint(rule.roles(), user.roles())) {
            types.all().stream()
                .filter(type -> isOf(rule, type))
                .forEach(type -> append(text, base + rule.channel() + "/" + type, rule, types));
          }
        }
      }
    }
    return text.toString();
  }

  private static boolean isOf(AccessRule rule, MessageType<?> type) {
    return AccessTable.rule(rule.channel().name(), type).equals(Optional.of(rule));
  }

  private static void append(
      StringBuilder text, String topic, AccessRule rule, MessageTypes types) {
    text.append("topic write ").append(topic).append('\n');
    if (rule.channel()
        .isRetainedBySource()) { // the last level matches any source name, but no type name
      text.append("topic write ").append(topic).append("/+\n");
      for (MessageType<?> known : types.all()) {
        text.append("topic deny ").append(topic).append('/').append(known.name()).append('\n');
      }
    }
  }
}
