package org.u2sa.interfaces.configuration;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** Values that a program put over those of a configuration file, and what became of them. */
final class Overrides {
  private final Map<String, FileVariable> statements = new LinkedHashMap<>();
  private final Map<String, InferredValue> inferred = new HashMap<>(); // until replaced

  /**
   * @param value as passed by the program
   */
  void put(FileVariable statement, Object value) {
    statements.put(statement.name(), statement);
    inferred.remove(statement.name());
    if (value instanceof InferredValue written) {
      inferred.put(statement.name(), written);
    }
  }

  void putAll(Overrides others) {
    statements.putAll(others.statements);
    inferred.putAll(others.inferred);
  }

  boolean contains(String name) {
    return statements.containsKey(name);
  }

  Optional<FileVariable> statement(String name) {
    return Optional.ofNullable(statements.get(name));
  }

  /** A statement with its text as written, if a text is declared. */
  FileVariable asText(FileVariable statement, VariableType declared) {
    InferredValue written = inferred.get(statement.name());
    return written == null || declared != VariableType.STRING
        ? statement
        : FileVariable.inMemory(statement.place(), statement.name(), written.text());
  }

  /** The declaration of a variable has given a type to its statement. */
  void declared(FileVariable before, FileVariable after) {
    statements.replace(after.name(), before, after);
  }

  /** Another value is in force. */
  void replaced(String name) {
    inferred.remove(name);
  }

  /**
   * Values in force of the overridden variables, as a program passes them.
   *
   * @param stated statements in force
   * @param values in the declared unit, but before the declaration in that of the statement
   */
  Map<String, Object> current(Map<String, FileVariable> stated, Map<String, Object> values) {
    Map<String, Object> all = new LinkedHashMap<>();
    for (String name : statements.keySet()) {
      FileVariable statement = stated.get(name);
      if (inferred.containsKey(name)) {
        all.put(name, inferred.get(name));
      } else if (statement != null
          && statement.value() instanceof Double
          && statement.unit().isPresent()) {
        all.put(name, statement.text() + " " + statement.unit().get());
      } else if (values.containsKey(name)) {
        all.put(name, values.get(name));
      }
    }
    return all;
  }
}
