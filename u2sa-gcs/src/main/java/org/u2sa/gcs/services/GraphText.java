package org.u2sa.gcs.services;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.gcs.terminal.TextTable;

/** A {@link ServiceGraph} to read, and for Graphviz. */
final class GraphText {
  private GraphText() {}

  /** A line each feed, by publisher, what hangs loose, and who has not answered. */
  static List<String> lines(ServiceGraph graph) {
    List<String> lines = new ArrayList<>();
    TextTable feeds = new TextTable("FROM", "TO", "CHANNEL", "TYPE");
    graph
        .feeds()
        .forEach(feed -> feeds.add(feed.from(), "-> " + feed.to(), feed.channel(), feed.type()));
    lines.addAll(feeds.lines());
    String known = graph.unanswered().isEmpty() ? "" : " that has answered";
    loose(lines, "Published to nobody" + known + ":", graph.unheard());
    loose(lines, "Subscribed to, published by nobody" + known + ":", graph.unfed());
    if (!graph.unanswered().isEmpty()) {
      lines.add("");
      lines.add("Heard, but without an answer: " + String.join(", ", graph.unanswered()));
    }
    return lines;
  }

  private static void loose(List<String> lines, String title, List<Loose> ends) {
    if (ends.isEmpty()) {
      return;
    }
    lines.add("");
    lines.add(title);
    TextTable table = new TextTable("NAME", "CHANNEL", "TYPE");
    ends.forEach(end -> table.add(end.service(), end.channel(), end.type()));
    table.lines().stream().skip(1).forEach(line -> lines.add("  " + line));
  }

  /** The graph in Graphviz's language; what hangs loose ends in a dashed line. */
  static List<String> dot(String systemId, ServiceGraph graph) {
    List<String> lines = new ArrayList<>();
    lines.add("digraph " + quoted(systemId) + " {");
    lines.add("  rankdir=LR;");
    lines.add("  node [shape=box, fontname=\"Helvetica\"];");
    lines.add("  edge [fontname=\"Helvetica\", fontsize=10];");
    for (String service : graph.services()) {
      String role = graph.roles().get(service);
      lines.add(
          "  "
              + quoted(service)
              + " [label="
              + quoted(role.isEmpty() ? service : service + "\\n" + role)
              + "];");
    }
    for (Feed feed : graph.feeds()) {
      lines.add(edge(feed.from(), feed.to(), feed.channel() + "\\n" + feed.type(), "solid"));
    }
    int number = 0;
    for (Loose end : graph.unheard()) {
      String nobody = "nobody" + number++;
      lines.add("  " + nobody + " [shape=point];");
      lines.add(edge(end.service(), nobody, end.channel() + "\\n" + end.type(), "dashed"));
    }
    for (Loose end : graph.unfed()) {
      String nobody = "nobody" + number++;
      lines.add("  " + nobody + " [shape=point];");
      lines.add(edge(nobody, end.service(), end.channel() + "\\n" + end.type(), "dashed"));
    }
    lines.add("}");
    return lines;
  }

  private static String edge(String from, String to, String label, String style) {
    return "  "
        + quoted(from)
        + " -> "
        + quoted(to)
        + " [label="
        + quoted(label)
        + ", style="
        + style
        + "];";
  }

  /** {@code \n} stays a line break, other backslashes and quotes are the text's own. */
  private static String quoted(String text) {
    return "\"" + text.replaceAll("\\\\(?!n)", "\\\\\\\\").replace("\"", "\\\"") + "\"";
  }
}
