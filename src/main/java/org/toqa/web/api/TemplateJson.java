package org.toqa.web.api;

import java.time.Instant;
import java.util.List;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplate.Parameter;
import org.toqa.web.input.OpenFields;
import org.toqa.web.input.ParameterKind;
import org.toqa.web.input.TemplateFiller;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * A template of tasks on the wire.
 *
 * @param order as it was given, with its floor and its name
 */
record TemplateJson(
    long id,
    String name,
    boolean shared,
    JsonNode order,
    List<ParameterJson> parameters,
    String user,
    Instant changedAt) {

  /**
   * @param required whether its value must be said with each order
   */
  record ParameterJson(String name, String field, ParameterKind kind, boolean required) {
    static ParameterJson of(Parameter parameter, ObjectNode order) {
      return new ParameterJson(
          parameter.name(),
          parameter.field(),
          ParameterKind.of(parameter.field()).orElseThrow(),
          OpenFields.value(order, parameter.field()) == null);
    }
  }

  static TemplateJson of(TaskTemplate template) {
    ObjectNode order = TemplateFiller.order(template);
    return new TemplateJson(
        template.id(),
        template.name(),
        template.shared(),
        order,
        template.parameters().stream().map(one -> ParameterJson.of(one, order)).toList(),
        template.user(),
        template.changedAt());
  }
}
