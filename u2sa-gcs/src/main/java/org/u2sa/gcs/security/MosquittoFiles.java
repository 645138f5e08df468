package org.u2sa.gcs.security;

import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.Set;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.Permission;
import org.u2sa.core.security.User;

/** The embedded broker's users and roles in Mosquitto's files (mosquitto.conf(5)). */
final class MosquittoFiles {
  private static final int LARGEST_PACKET = 1 << 21; // as the embedded broker's

  private MosquittoFiles() {}

  static String configuration(Path folder, String bind, int port) {
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
        "max_packet_size " + LARGEST_PACKET,
        "max_queued_messages 1000",
        "max_queued_bytes 16777216",
        "set_tcp_nodelay true",
        "");
  }

  static String passwords(Collection<User> users) {
    StringBuilder text = new StringBuilder();
    users.forEach(
        user ->
            text.append(user.name())
                .append(':')
                .append(user.password().forMosquitto())
                .append('\n'));
    return text.toString();
  }

  static String rights(Collection<User> users) {
    StringBuilder text = new StringBuilder("# Written by ./u2sa security mosquitto.\n");
    for (User user : users) {
      text.append("\n# ")
          .append(user.rolesText())
          .append("\nuser ")
          .append(user.name())
          .append('\n');
      for (String system : user.systems()) {
        String level = system.equals(User.EVERY_SYSTEM) ? "+" : system;
        text.append("topic read u2sa/").append(level).append("/#\n");
        for (String filter : filters(user)) {
          text.append("topic write u2sa/").append(level).append('/').append(filter).append('\n');
        }
      }
    }
    return text.toString();
  }

  private static Set<String> filters(User user) {
    Set<String> filters = new LinkedHashSet<>();
    for (AccessRole role : AccessRole.values()) { // in their order, whatever the set's
      if (user.roles().contains(role)) {
        for (Permission permission : role.permissions()) {
          add(filters, permission);
        }
      }
    }
    return filters;
  }

  private static void add(Set<String> filters, Permission permission) {
    if (permission.types().isEmpty()) {
      filters.add(permission.channel() + "/#");
    }
    permission.types().forEach(type -> filters.add(permission.channel() + "/" + type + "/#"));
  }
}
