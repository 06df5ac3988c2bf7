<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="chosen" required="true" %>
<%@ attribute name="none" required="true" description="key of the text for no choice" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<label for="parking"><fmt:message key="robots.add.parking"/></label>
<select id="parking" name="parking" ${not empty errors.parking ? 'aria-invalid="true" aria-describedby="parking-help"' : ''}>
  <option value=""><fmt:message key="${none}"/></option>
  <c:forEach items="${floors}" var="floor"><c:forEach items="${floor.parking()}" var="place"><option dir="auto" ${place.name == chosen ? 'selected' : ''}><c:out value="${place.name}"/></option></c:forEach></c:forEach>
</select>
<c:if test="${not empty errors.parking}"><small id="parking-help" class="wrong"><bdi><c:out value="${errors.parking}"/></bdi></small></c:if>
