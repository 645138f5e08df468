package org.u2sa.gcs.services;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.gcs.terminal.TextTable;

/** A {@link ServiceGraph} to read, and for programs that draw: Mermaid and Graphviz. */
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

  /** The graph in Mermaid's language; what hangs loose ends in a dashed line. */
  static List<String> mermaid(ServiceGraph graph) {
    List<String> lines = new ArrayList<>();
    lines.add("flowchart LR");
    List<String> services = graph.services();
    for (int i = 0; i < services.size(); i++) {
      String role = graph.roles().get(services.get(i));
      String label = escaped(services.get(i)) + (role.isEmpty() ? "" : "<br/>" + escaped(role));
      lines.add("  s" + i + "[\"" + label + "\"]");
    }
    for (Edge edge : edges(graph)) {
      String from = edge.from().map(name -> "s" + services.indexOf(name)).orElse(edge.loose());
      String to = edge.to().map(name -> "s" + services.indexOf(name)).orElse(edge.loose());
      if (edge.isLoose()) {
        lines.add("  " + edge.loose() + "(( ))");
      }
      String arrow = edge.isLoose() ? " -.->" : " -->";
      String label = escaped(edge.channel()) + "<br/>" + escaped(edge.type());
      lines.add("  " + from + arrow + "|\"" + label + "\"| " + to);
    }
    return lines;
  }

  /** Mermaid's own characters as its entities. */
  private static String escaped(String text) {
    return text.replace("#", "#35;").replace("\"", "#quot;").replace("<", "#lt;");
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
      String label = quoted(role.isEmpty() ? service : service + "\\n" + role);
      lines.add("  " + quoted(service) + " [label=" + label + "];");
    }
    for (Edge edge : edges(graph)) {
      if (edge.isLoose()) {
        lines.add("  " + edge.loose() + " [shape=point];");
      }
      lines.add(
          String.format(
              "  %s -> %s [label=%s, style=%s];",
              quoted(edge.from().orElse(edge.loose())),
              quoted(edge.to().orElse(edge.loose())),
              quoted(edge.channel() + "\\n" + edge.type()),
              edge.isLoose() ? "dashed" : "solid"));
    }
    lines.add("}");
    return lines;
  }

  /** An arrow; where nobody is at one end, it hangs loose from a point of its own name. */
  private record Edge(
      Optional<String> from, Optional<String> to, String channel, String type, String loose) {
    boolean isLoose() {
      return from.isEmpty() || to.isEmpty();
    }
  }

  private static List<Edge> edges(ServiceGraph graph) {
    List<Edge> edges = new ArrayList<>();
    for (Feed feed : graph.feeds()) {
      edges.add(
          new Edge(
              Optional.of(feed.from()), Optional.of(feed.to()), feed.channel(), feed.type(), ""));
    }
    int number = 0;
    for (Loose end : graph.unheard()) {
      edges.add(
          new Edge(
              Optional.of(end.service()),
              Optional.empty(),
              end.channel(),
              end.type(),
              "nobody" + number++));
    }
    for (Loose end : graph.unfed()) {
      edges.add(
          new Edge(
              Optional.empty(),
              Optional.of(end.service()),
              end.channel(),
              end.type(),
              "nobody" + number++));
    }
    return edges;
  }

  /** {@code \n} stays a line break, other backslashes and quotes are the text's own. */
  private static String quoted(String text) {
    return "\"" + text.replaceAll("\\\\(?!n)", "\\\\\\\\").replace("\"", "\\\"") + "\"";
  }
}
