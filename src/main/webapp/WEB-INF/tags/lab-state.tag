<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" description="how far a run of the laboratory is" %>
<%@ attribute name="view" required="true" type="org.toqa.web.page.LabRunView" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<span class="state" data-state="${view.run().state()}"><fmt:message key="laboratory.state.${view.run().state()}"/></span>
<c:if test="${view.run().state() == 'RUNNING'}">
  <fmt:message key="laboratory.progress" var="label"/>
  <progress max="1" value="${empty view.progress() ? 0 : view.progress().share()}" aria-label="${label}"></progress>
  <small class="faint" data-step><c:if test="${not empty view.progress()}"><t:english text="${view.progress().step()}"/></c:if></small>
</c:if>
