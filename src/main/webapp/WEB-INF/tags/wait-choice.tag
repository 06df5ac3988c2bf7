<%@ tag pageEncoding="UTF-8" %>
<%@ attribute name="name" required="true" %>
<%@ attribute name="label" required="true" %>
<%@ attribute name="chosen" required="false" %>
<%@ attribute name="charges" type="java.lang.Boolean" description="whether a charger may be chosen there" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<select name="${name}" aria-label="${label}">
  <option value=""><fmt:message key="newTask.wait.none"/></option>
  <c:forTokens items="person,60,300,900,3600${charges ? ',80%,100%' : ''}" delims="," var="wait"><option value="${wait}" ${wait == chosen ? 'selected' : ''}><fmt:message key="newTask.wait.${wait}"/></option></c:forTokens>
  <c:set var="usual" value=",person,60,300,900,3600${charges ? ',80%,100%' : ''},"/>
  <c:set var="other" value=",${chosen},"/>
  <c:if test="${not empty chosen and not usual.contains(other)}"><option value="<c:out value="${chosen}"/>" selected><c:choose><c:when test="${chosen.endsWith('%')}"><c:out value="${chosen}"/></c:when><c:otherwise><fmt:message key="newTask.wait.seconds"><fmt:param><c:out value="${chosen}"/></fmt:param></fmt:message></c:otherwise></c:choose></option></c:if>
</select>
