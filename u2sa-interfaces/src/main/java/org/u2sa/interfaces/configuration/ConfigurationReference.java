package org.u2sa.interfaces.configuration;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Writes the configuration reference from the code: a table for each class that declares variables,
 * by {@link VariableDeclaration}s in static final fields or by a record's {@link Variable}s.
 */
public final class ConfigurationReference {
  private static final String HEADER =
      "| Variable | Type | Unit | Range | Default | Meaning |\n|---|---|---|---|---|---|\n";

  private ConfigurationReference() {}

  /**
   * A section for each of these classes, in this order, and before them one for each superclass
   * that declares variables: their subclasses refer to it.
   *
   * @throws IllegalArgumentException if a variable has no description
   */
  public static String markdownFor(Class<?>... services) {
    Set<Class<?>> inherited = new LinkedHashSet<>();
    Set<Class<?>> own = new LinkedHashSet<>();
    for (Class<?> service : services) {
      own.add(service);
      inherited.addAll(declaringAncestors(service));
    }
    inherited.removeAll(own);
    StringBuilder text = new StringBuilder();
    inherited.forEach(type -> section(text, type));
    own.forEach(type -> section(text, type));
    return text.toString();
  }

  /**
   * A section for the variables that a service declared, wherever its class keeps them: see {@link
   * XmlConfiguration#declared()}.
   *
   * @param heading name of the service
   * @throws IllegalArgumentException if a variable has no description
   */
  public static String markdownFor(String heading, Collection<VariableDeclaration<?>> variables) {
    StringBuilder text = new StringBuilder("## ").append(heading).append("\n\n");
    if (variables.isEmpty()) {
      return text.append("No variables of its own.\n").toString();
    }
    text.append(HEADER);
    variables.forEach(variable -> row(text, heading, variable));
    return text.toString();
  }

  private static void section(StringBuilder text, Class<?> type) {
    text.append(text.length() == 0 ? "" : "\n");
    text.append(markdownFor(type.getSimpleName(), variables(type)));
    List<String> links = new ArrayList<>();
    for (Class<?> ancestor : declaringAncestors(type)) {
      String name = ancestor.getSimpleName();
      links.add("[" + name + "](#" + name.toLowerCase(Locale.ROOT) + ")");
    }
    if (!links.isEmpty()) {
      text.append("\nAlso those of ").append(String.join(", ", links)).append(".\n");
    }
  }

  private static void row(StringBuilder text, String heading, VariableDeclaration<?> variable) {
    if (variable.description().isEmpty()) {
      throw new IllegalArgumentException(
          heading + ", " + variable + ": no description for the reference");
    }
    cell(text, "`" + variable.name() + "`");
    cell(text, variable.type().xmlName());
    cell(text, variable.unit());
    cell(text, allowed(variable));
    cell(text, defaultOf(variable));
    cell(text, variable.description());
    text.append("|\n");
  }

  private static void cell(StringBuilder text, String content) {
    String safe = content.replace("|", "\\|").replaceAll("\\s+", " ").trim();
    text.append("| ").append(safe).append(safe.isEmpty() ? "" : " ");
  }

  private static String allowed(VariableDeclaration<?> variable) {
    if (!variable.choices().isEmpty()) {
      return variable.choicesText();
    }
    return variable.range().isAny() ? "" : variable.range().toString();
  }

  private static String defaultOf(VariableDeclaration<?> variable) {
    return variable
        .ifAbsent()
        .map(value -> value instanceof String ? "\"" + value + "\"" : NumberText.ofValue(value))
        .orElse("required");
  }

  private static List<Class<?>> declaringAncestors(Class<?> type) {
    List<Class<?>> ancestors = new ArrayList<>();
    for (Class<?> up = type.getSuperclass(); up != null; up = up.getSuperclass()) {
      if (!variables(up).isEmpty()) {
        ancestors.add(0, up);
      }
    }
    return ancestors;
  }

  private static List<VariableDeclaration<?>> variables(Class<?> type) {
    List<VariableDeclaration<?>> variables = new ArrayList<>();
    for (Field field : type.getDeclaredFields()) {
      int modifiers = field.getModifiers();
      if (field.getType() == VariableDeclaration.class
          && Modifier.isStatic(modifiers)
          && Modifier.isFinal(modifiers)) {
        variables.add(value(field));
      }
    }
    RecordBinding.in(type).ifPresent(binding -> variables.addAll(binding.declarations()));
    for (Class<?> nested : type.getDeclaredClasses()) {
      RecordBinding.in(nested).ifPresent(binding -> variables.addAll(binding.declarations()));
    }
    return variables;
  }

  private static VariableDeclaration<?> value(Field field) {
    try {
      field.setAccessible(true);
      return (VariableDeclaration<?>) field.get(null);
    } catch (IllegalAccessException e) {
      throw new IllegalStateException(field + " cannot be read", e);
    }
  }
}
