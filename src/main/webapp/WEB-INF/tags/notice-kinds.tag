<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="id" required="true" %>
<%@ attribute name="again" required="true" type="java.lang.Boolean" description="the form is shown again with what was sent" %>
<%@ attribute name="chosen" type="java.util.Set" description="those that are chosen; all if left out" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<fieldset${again and not empty errors.kinds ? ' aria-describedby="'.concat(id).concat('-help"') : ''}>
  <legend><fmt:message key="webhooks.kinds"/></legend>
  <div class="kinds">
    <c:forEach items="${kinds}" var="kind">
      <c:set var="isChosen" value="${not again and (empty chosen or chosen.contains(kind))}"/>
      <c:if test="${again}"><c:forEach items="${paramValues.kinds}" var="given"><c:if test="${given == kind.word()}"><c:set var="isChosen" value="${true}"/></c:if></c:forEach></c:if>
      <label><input type="checkbox" name="kinds" value="${kind.word()}"${isChosen ? ' checked' : ''}> <fmt:message key="notices.kind.${kind.word()}"/></label>
    </c:forEach>
  </div>
  <c:if test="${again and not empty errors.kinds}"><small id="${id}-help" class="wrong"><bdi><c:out value="${errors.kinds}"/></bdi></small></c:if>
</fieldset>
