<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" description="a number that an experiment is started with" %>
<%@ attribute name="experiment" required="true" %>
<%@ attribute name="name" required="true" description="of the field" %>
<%@ attribute name="value" required="true" description="unless it was entered" %>
<%@ attribute name="sent" required="true" type="java.lang.Boolean" description="whether this experiment's form was sent" %>
<%@ attribute name="label" description="key of the text; else the meaning says it" %>
<%@ attribute name="meaning" description="in English" %>
<%@ attribute name="unit" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="id" value="${experiment}-${fn:replace(name, '.', '-')}"/>
<c:set var="error" value="${sent ? errors[name] : null}"/>
<div>
  <label for="${id}"><c:choose><c:when test="${not empty label}"><fmt:message key="${label}"/></c:when><c:otherwise><t:english text="${meaning}${empty unit ? '' : ' ('}${unit}${empty unit ? '' : ')'}"/></c:otherwise></c:choose></label>
  <input id="${id}" name="${name}" dir="ltr" inputmode="decimal" autocomplete="off" value="${fn:escapeXml(sent and param[name] != null ? param[name] : value)}"${empty error ? '' : ' aria-invalid="true" aria-describedby="'.concat(id).concat('-help"')}>
  <c:if test="${not empty error}"><small id="${id}-help"><bdi><c:out value="${error}"/></bdi></small></c:if>
</div>
