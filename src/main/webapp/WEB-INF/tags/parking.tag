<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="chosen" required="true" %>
<%@ attribute name="on" required="false" description="the floor whose parking points there are to choose from; empty: those of all" %>
<%@ attribute name="none" required="true" description="key of the text for no choice" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<label for="parking"><fmt:message key="robots.add.parking"/></label>
<select id="parking" name="parking" ${not empty errors.parking ? 'aria-invalid="true" aria-describedby="parking-help"' : ''}>
  <option value=""><fmt:message key="${none}"/></option>
  <c:forEach items="${floors}" var="of">
    <c:if test="${empty on or on == of.name()}">
      <c:if test="${fn:length(floors) > 1 and empty on}"><optgroup label="<c:out value="${of.name()}"/>"></c:if>
      <c:forEach items="${of.parking()}" var="place"><option dir="auto" ${place.name == chosen ? 'selected' : ''}><c:out value="${place.name}"/></option></c:forEach>
      <c:if test="${fn:length(floors) > 1 and empty on}"></optgroup></c:if>
    </c:if>
  </c:forEach>
</select>
<c:if test="${not empty errors.parking}"><small id="parking-help" class="wrong"><bdi><c:out value="${errors.parking}"/></bdi></small></c:if>
