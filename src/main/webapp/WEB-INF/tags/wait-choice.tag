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
</select>
