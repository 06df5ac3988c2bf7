<%@ tag pageEncoding="UTF-8" trimDirectiveWhitespaces="true" body-content="empty" %>
<%@ attribute name="name" required="true" %>
<%@ attribute name="label" required="true" %>
<%@ attribute name="words" required="true" %>
<%@ attribute name="count" type="java.lang.Integer" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%-- One of a few words, chosen when a user is deleted. The first one is chosen already. --%>
<label for="delete-${name}"><fmt:message key="${label}"><fmt:param value="${count}"/></fmt:message></label>
<select id="delete-${name}" name="${name}"${empty errors[name] ? '' : ' aria-invalid="true" aria-describedby="delete-'.concat(name).concat('-help"')}>
  <c:forTokens items="${words}" delims="," var="word"><option value="${word}"${param[name] == word ? ' selected' : ''}><fmt:message key="users.delete.choice.${word}"/></option></c:forTokens>
</select>
<c:if test="${not empty errors[name]}"><small id="delete-${name}-help" class="wrong"><bdi><c:out value="${errors[name]}"/></bdi></small></c:if>
